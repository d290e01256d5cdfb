-- Axial symmetry: r to the right, z up. The coil's centre is the origin, the magnet follows in +z.
bottom = coil_length / 2 + gap
top = bottom + magnet_length
coil_low = -coil_length / 2
coil_high = coil_length / 2
wall = 30 * size          -- radius of the outermost circle, where the potential is zero
near_r = 2 * size         -- a box of air with a fine mesh
near_low = coil_low - size
near_high = top + size
fine = size / 40          -- lengths of elements
medium = size / 20

newdocument(0)
mi_probdef(0, "millimeters", "axi", 1e-8, 0, 30)

function side(r1, z1, r2, z2)
  mi_addnode(r1, z1)
  mi_addnode(r2, z2)
  mi_addsegment(r1, z1, r2, z2)
end

-- The coil
side(coil_inner, coil_low, coil_outer, coil_low)
side(coil_outer, coil_low, coil_outer, coil_high)
side(coil_outer, coil_high, coil_inner, coil_high)
side(coil_inner, coil_high, coil_inner, coil_low)
-- The magnet, whose fourth side is on the axis
side(0, bottom, magnet_radius, bottom)
side(magnet_radius, bottom, magnet_radius, top)
side(magnet_radius, top, 0, top)
-- The air near by
side(0, near_low, near_r, near_low)
side(near_r, near_low, near_r, near_high)
side(near_r, near_high, 0, near_high)
-- The axis, piece by piece, and the wall
side(0, -wall, 0, near_low)
side(0, near_low, 0, bottom)
side(0, bottom, 0, top)
side(0, top, 0, near_high)
side(0, near_high, 0, wall)
mi_addarc(0, -wall, 0, wall, 180, 2.5)

mi_addboundprop("zero", 0, 0, 0, 0, 0, 0, 0, 0, 0)
mi_selectarcsegment(wall, 0)
mi_setarcsegmentprop(2.5, "zero", 0, 0)
mi_clearselected()

-- name, mu_r, mu_z, coercivity, current density, conductivity; then lamination, of which there is none
mi_addmaterial("air", 1, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0)
mi_addmaterial("winding", 1, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0)
mi_addmaterial("magnet", recoil, recoil, coercivity, 0, 0, 0, 0, 1, 0, 0, 0)

-- Currents into the page are positive in FEMM, and their moment is along +z as the magnet's is: they attract.
mi_addcircprop("coil", -current, 1)

function label(r, z, material, length, circuit, direction, group, windings)
  mi_addblocklabel(r, z)
  mi_selectlabel(r, z)
  mi_setblockprop(material, 0, length, circuit, direction, group, windings)
  mi_clearselected()
end

label((coil_inner + coil_outer) / 2, 0, "winding", fine, "coil", 0, 1, turns)
label(magnet_radius / 2, (bottom + top) / 2, "magnet", fine, "<None>", 90, 2, 0)
label((near_r + coil_outer) / 2, 0, "air", medium, "<None>", 0, 0, 0)
label(wall / 2, 0, "air", wall / 20, "<None>", 0, 0, 0)

mi_zoomnatural()
mi_saveas("pair.fem")
mi_analyze()
mi_loadsolution()

-- Both away from the coil: Maxwell's stress round the magnet, and what the coil's J x B is the reaction of.
mo_groupselectblock(2)
by_stress = mo_blockintegral(19)
mo_clearblock()
mo_groupselectblock(1)
by_lorentz = -mo_blockintegral(12)
mo_clearblock()
showconsole()
print("force on the magnet, N, away from the coil: by stress " .. by_stress .. ", by J x B " .. by_lorentz)
