// What whoever prints the mould may choose.
part = "assembly";
mould_wall = 3;
fit = 0.2;             // between the lips of the upper half and the lower half
lip = 6;               // by which the upper half reaches down outside
bar = 6;               // width of the bars that carry the upper half
flange_overhang = 2;   // of the bobbin's flanges over the finished coil
flange_thickness = 2;
blade = 0.6;           // width of the slots that guide the knife
$fn = 128;             // a multiple of 4

plug_start = parts[0][1];
plug_end = parts[len(parts) - 1][1] + parts[len(parts) - 1][2];
eps = 0.01;            // so that what is cut away, or joined, does not end in the same plane

// A shape across the actuator (x across, y up), drawn out along it.
module along(start, length) {
  translate([start, 0, 0]) rotate([90, 0, 90]) linear_extrude(height = length) children();
}

// Where a part lies: round below, open above; up to `top` above the underside.
module pocket(p, top) {
  radius = p[3] + clearance;
  along(p[1], p[2]) {
    translate([0, axis_height]) circle(r = radius);
    translate([-radius, axis_height]) square([2 * radius, top - axis_height]);
  }
}

module pockets(top) {
  for (p = parts) pocket(p, top);
}

module solid(p) {
  along(p[1] + (p[2] - p[5]) / 2, p[5]) translate([0, axis_height]) difference() {
    circle(r = p[3]);
    if (p[4] > 0) circle(r = p[4]);
  }
}

module solids(kind) {
  for (p = parts) if (p[0] == kind) solid(p);
}

module block(height) {
  translate([0, -body_width / 2, 0]) cube([body_length, body_width, height]);
}

// The strip under the slits. It is cast with the body.
module bottom_layer() {
  block(bottom_layer);
}

// As it comes out of the mould.
module body() {
  difference() {
    block(body_height);
    pockets(body_height + 1);
  }
}

// What is cast afterwards: walls of the parts, bores, and what bonds and covers them.
module filling() {
  difference() {
    pockets(body_height);
    solids("coil");
    solids("magnet");
  }
}

// A box, open above: the outside of the body.
module mould_lower() {
  difference() {
    translate([-mould_wall, -body_width / 2 - mould_wall, -mould_wall])
      cube([body_length + 2 * mould_wall, body_width + 2 * mould_wall, body_height + mould_wall]);
    block(body_height + 1);
  }
}

// A bar across the lower half, from x = `start`, with lips on both sides of it.
module bar_across(start) {
  half = body_width / 2 + mould_wall + fit;
  translate([start, -half - mould_wall, body_height]) cube([bar, 2 * (half + mould_wall), mould_wall]);
  for (y = [-half - mould_wall, half])
    translate([start, y, body_height - lip]) cube([bar, mould_wall, lip + eps]);
}

// A bar along it, from the plug over an end, with a lip there. `end` is the outside of that end.
module bar_along(from, end) {
  outwards = end > from ? 1 : -1;
  outside = end + outwards * fit;
  low = min(from, outside);
  translate([outwards > 0 ? low - eps : low - mould_wall, -bar / 2, body_height])
    cube([abs(outside - from) + mould_wall + eps, bar, mould_wall]);
  translate([outwards > 0 ? outside : outside - mould_wall, -bar / 2, body_height - lip])
    cube([mould_wall, bar, lip + eps]);
}

// The pockets, hanging from bars that lie on the rim of the lower half. The mould is filled and vented beside them.
module mould_upper() {
  pockets(body_height + mould_wall);
  bar_across(plug_start);
  bar_across(plug_end - bar);
  bar_along(plug_start, -mould_wall);
  bar_along(plug_end, body_length + mould_wall);
}

// What the closed mould leaves free, up to its rim.
module cavity() {
  difference() {
    block(body_height);
    mould_lower();
    mould_upper();
  }
}

// To wind a coil on, screwed together with the loose flange; the slot lets the start of the wire out.
module flange() {
  difference() {
    cylinder(r = coil_outer_diameter / 2 + flange_overhang, h = flange_thickness);
    translate([0, 0, -1]) cylinder(d = bobbin_hole, h = flange_thickness + 2);
  }
}
bobbin_hole = min(3.2, coil_bore_diameter / 2);
module bobbin() {
  difference() {
    union() {
      difference() {
        flange();
        translate([coil_bore_diameter / 2 - 1, -0.5, -1]) cube([coil_outer_diameter, 1, flange_thickness + 2]);
      }
      translate([0, 0, flange_thickness - eps]) cylinder(d = coil_bore_diameter, h = coil_length + eps);
    }
    translate([0, 0, -1]) cylinder(d = bobbin_hole, h = coil_length + flange_thickness + 2);
  }
}

// The bonded actuator lies in it while the slits are cut: the knife ends at the bottom layer.
module cutting_box() {
  difference() {
    mould_lower();
    for (x = joints)
      translate([x - blade / 2, -body_width, bottom_layer]) cube([blade, 2 * body_width, body_height + 1]);
  }
}

if (part == "body") body();
if (part == "bottom_layer") bottom_layer();
if (part == "filling") filling();
if (part == "coils") solids("coil");
if (part == "magnets") solids("magnet");
if (part == "mould_lower") mould_lower();
if (part == "mould_upper") translate([0, 0, body_height + mould_wall]) rotate([180, 0, 0]) mould_upper();
if (part == "cavity") cavity();
if (part == "bobbin") bobbin();
if (part == "bobbin_flange") flange();
if (part == "cutting_box") cutting_box();
if (part == "assembly") {
  color("BurlyWood", 0.5) body();
  color("Peru") solids("coil");
  color("SlateGray") solids("magnet");
}
