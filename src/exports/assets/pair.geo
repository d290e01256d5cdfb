// Coil and magnet on one axis: the half plane r >= 0 that axial symmetry leaves.
// gmsh -2 -format msh22 pair.geo -o pair.msh, then pair.pro.
//
// x is the radius and y the axis, in mm; the mesh is saved in m. The coil's centre is the origin, the magnet follows in
// +y.
Include "pair_data.pro";
SetFactory("OpenCASCADE");

far = 9 * size;       // radius of the ball of true size
outside = 13 * size;  // radius of the mesh, of whose shell pair.pro makes all of space

// A layer of air round the magnet alone, for Maxwell's stress: between 0.2 and 0.8 of the gap.
shell = gap < 0.2 * size ? gap : 0.2 * size;
near = 0.2 * shell;
away = 0.8 * shell;

// Lengths of elements: in the bodies, at the edges of the magnet, where the field is largest, and in the layer.
thinnest = coil_outer - coil_inner;
thinnest = coil_length < thinnest ? coil_length : thinnest;
thinnest = magnet_length < thinnest ? magnet_length : thinnest;
thinnest = magnet_radius < thinnest ? magnet_radius : thinnest;
h_body = (0.1 * size < thinnest / 3 ? 0.1 * size : thinnest / 3) / fineness;
h_edge = 0.15 * h_body;
h_layer = (away - near) / (1.5 * fineness) < h_body ? (away - near) / (1.5 * fineness) : h_body;
h_far = far / (6 * fineness);

middle = coil_length / 2 + gap + magnet_length / 2;  // of the magnet

// Rectangle(tag) = {r, y, 0, width, height}
Rectangle(1) = {coil_inner, -coil_length / 2, 0, coil_outer - coil_inner, coil_length};
Rectangle(2) = {0, middle - magnet_length / 2, 0, magnet_radius, magnet_length};
Rectangle(3) = {0, middle - magnet_length / 2 - near, 0, magnet_radius + near, magnet_length + 2 * near};
Rectangle(4) = {0, middle - magnet_length / 2 - away, 0, magnet_radius + away, magnet_length + 2 * away};

Point(1001) = {0, -outside, 0};
Point(1002) = {0, -far, 0};
Point(1003) = {0, 0, 0};
Point(1004) = {0, far, 0};
Point(1005) = {0, outside, 0};
Point(1006) = {far, 0, 0};
Point(1007) = {outside, 0, 0};
Circle(1001) = {1002, 1003, 1006};
Circle(1002) = {1006, 1003, 1004};
Circle(1003) = {1001, 1003, 1007};
Circle(1004) = {1007, 1003, 1005};
Line(1005) = {1002, 1004};
Line(1006) = {1001, 1002};
Line(1007) = {1004, 1005};
Curve Loop(1001) = {1001, 1002, -1005};
Plane Surface(101) = {1001};
Curve Loop(1002) = {1003, 1004, -1007, -1002, -1001, -1006};
Plane Surface(102) = {1002};

BooleanFragments{ Surface{101, 102}; Delete; }{ Surface{1, 2, 3, 4}; Delete; }

// The pieces by where they lie.
e = 1e-5 * size;
coil() = Surface In BoundingBox{coil_inner - e, -coil_length / 2 - e, -e, coil_outer + e, coil_length / 2 + e, e};
magnet() = Surface In BoundingBox{-e, middle - magnet_length / 2 - e, -e,
                                  magnet_radius + e, middle + magnet_length / 2 + e, e};
inside() = Surface In BoundingBox{-e, middle - magnet_length / 2 - near - e, -e,
                                  magnet_radius + near + e, middle + magnet_length / 2 + near + e, e};
layer() = Surface In BoundingBox{-e, middle - magnet_length / 2 - away - e, -e,
                                 magnet_radius + away + e, middle + magnet_length / 2 + away + e, e};
ball() = Surface In BoundingBox{-e, -far - e, -e, far + e, far + e, e};
all() = Surface{:};
shell_of_space() = all();
shell_of_space() -= ball();
air() = ball();
air() -= layer();
air() -= coil();
layer() -= inside();
skin() = inside();
skin() -= magnet();

// Lengths of elements, at the points of each piece; the last word counts.
MeshSize{ PointsOf{ Surface{all()}; } } = h_far;
MeshSize{ PointsOf{ Surface{coil()}; } } = h_body;
MeshSize{ PointsOf{ Surface{layer(), inside()}; } } = h_layer;
MeshSize{ PointsOf{ Surface{magnet()}; } } = h_edge;

Mesh.ScalingFactor = 1e-3;
Mesh.MshFileVersion = 2.2;

Physical Surface("coil", 1) = coil();
Physical Surface("magnet", 2) = magnet();
Physical Surface("air within the layer", 3) = skin();
Physical Surface("layer", 4) = layer();
Physical Surface("air", 5) = air();
Physical Surface("shell of space", 6) = shell_of_space();
Physical Curve("axis and outermost circle", 11) = CombinedBoundary{ Surface{all()}; };
