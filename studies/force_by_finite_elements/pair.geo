// Coil, magnet, second coil and a piece of iron on one axis: the half plane r >= 0 that axial symmetry leaves.
//
// x is the radius and y the axis, in mm; the mesh is saved in m. The first coil's centre is the origin, the magnet and the
// second coil follow in +y. finite_elements.py sets the numbers (gmsh -setnumber NAME VALUE); these are the paper's finger.
SetFactory("OpenCASCADE");

DefineConstant[
  gap = 0.9,               // between the coil's face and the magnet's, and between the magnet's and the second coil's
  coil_inner = 3, coil_outer = 9.5, coil_length = 12,
  magnet_radius = 10, magnet_length = 6,
  second_coil = 1,         // 0: there is none
  iron_inner = 0, iron_outer = 0, iron_low = 0, iron_high = 0,  // no iron where iron_outer is 0
  fineness = 1,            // all lengths of elements are divided by it
  far = 90,                // radius of the ball of true size
  outside = 130            // radius of the mesh, of whose shell pair.pro makes all of space if it is told to
];

// A shell of air round the magnet alone, for Maxwell's stress: between 0.2 and 0.8 of the gap.
shell = gap < 2 ? gap : 2;
near = 0.2 * shell;
away = 0.8 * shell;

h_body = 1.0 / fineness;                 // coils and magnet
h_edge = 0.15 / fineness;                // edges of the magnet, where the field is largest
h_shell = (away - near) / (1.5 * fineness) < h_body ? (away - near) / (1.5 * fineness) : h_body;
h_iron = 1.0 / fineness;
h_far = far / (6 * fineness);

middle = coil_length / 2 + gap + magnet_length / 2;  // of the magnet

// Rectangle(tag) = {r, y, 0, width, height}
Rectangle(1) = {coil_inner, -coil_length / 2, 0, coil_outer - coil_inner, coil_length};
Rectangle(2) = {0, middle - magnet_length / 2, 0, magnet_radius, magnet_length};
Rectangle(4) = {0, middle - magnet_length / 2 - near, 0, magnet_radius + near, magnet_length + 2 * near};
Rectangle(5) = {0, middle - magnet_length / 2 - away, 0, magnet_radius + away, magnet_length + 2 * away};
bodies() = {1, 2, 4, 5};
If (second_coil)
  Rectangle(3) = {coil_inner, 2 * middle - coil_length / 2, 0, coil_outer - coil_inner, coil_length};
  bodies() += 3;
EndIf
If (iron_outer > 0)
  Rectangle(6) = {iron_inner, iron_low, 0, iron_outer - iron_inner, iron_high - iron_low};
  bodies() += 6;
EndIf

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

BooleanFragments{ Surface{101, 102}; Delete; }{ Surface{bodies()}; Delete; }

// The pieces by where they lie.
e = 1e-4;
coil() = Surface In BoundingBox{coil_inner - e, -coil_length / 2 - e, -e, coil_outer + e, coil_length / 2 + e, e};
second() = {};
If (second_coil)
  second() = Surface In BoundingBox{coil_inner - e, 2 * middle - coil_length / 2 - e, -e,
                                    coil_outer + e, 2 * middle + coil_length / 2 + e, e};
EndIf
magnet() = Surface In BoundingBox{-e, middle - magnet_length / 2 - e, -e,
                                  magnet_radius + e, middle + magnet_length / 2 + e, e};
inside() = Surface In BoundingBox{-e, middle - magnet_length / 2 - near - e, -e,
                                  magnet_radius + near + e, middle + magnet_length / 2 + near + e, e};
layer() = Surface In BoundingBox{-e, middle - magnet_length / 2 - away - e, -e,
                                 magnet_radius + away + e, middle + magnet_length / 2 + away + e, e};
ball() = Surface In BoundingBox{-e, -far - e, -e, far + e, far + e, e};
all() = Surface{:};
iron() = {};
If (iron_outer > 0)
  iron() = Surface In BoundingBox{iron_inner - e, iron_low - e, -e, iron_outer + e, iron_high + e, e};
EndIf
shell_of_space() = all();
shell_of_space() -= ball();
air() = ball();
air() -= layer();
air() -= coil();
air() -= second();
air() -= iron();
layer() -= inside();
skin() = inside();
skin() -= magnet();

// Lengths of elements, at the points of each piece; the last word counts.
MeshSize{ PointsOf{ Surface{all()}; } } = h_far;
MeshSize{ PointsOf{ Surface{iron()}; } } = h_iron;
MeshSize{ PointsOf{ Surface{coil(), second()}; } } = h_body;
MeshSize{ PointsOf{ Surface{layer(), inside()}; } } = h_shell;
MeshSize{ PointsOf{ Surface{magnet()}; } } = h_edge;

Mesh.ScalingFactor = 1e-3;
Mesh.MshFileVersion = 2.2;

Physical Surface("coil", 1) = coil();
Physical Surface("magnet", 2) = magnet();
If (second_coil)
  Physical Surface("second coil", 3) = second();
EndIf
Physical Surface("air within the layer", 4) = skin();
Physical Surface("layer", 5) = layer();
If (iron_outer > 0)
  Physical Surface("iron", 6) = iron();
EndIf
Physical Surface("air", 7) = air();
Physical Surface("shell of space", 8) = shell_of_space();
Physical Curve("axis and outermost circle", 11) = CombinedBoundary{ Surface{all()}; };
