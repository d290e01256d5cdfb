#include "exports/field/getdp_texts.hpp"

namespace coilwright::exports {

const std::string_view getdp_problem =
    R"(// The static field of a coil and a magnet on one axis, and the force between them by two routes.
// getdp pair.pro -msh pair.msh -solve Solve: forces.txt has, a line each, the force on the magnet in N, away from the
// coil, by J x B over the coil and by Maxwell's stress round the magnet, and the flux linkage of the coil in Wb.
//
// The vector potential has one component, along the angle. In GetDP's frame (x the radius, y the axis, z out of the
// plane) z is minus the angle. A positive current runs against the angle: its moment is against the magnet's.
Include "pair_data.pro";

Group {
  Coil = Region[1];
  Magnet = Region[2];
  Within = Region[3];
  Layer = Region[4];
  Air = Region[5];
  Space = Region[6];
  Zero = Region[11];
  All_ = Region[{Coil, Magnet, Within, Layer, Air, Space}];
}

Function {
  mu0 = 4e-7 * Pi;
  nu[Region[{Coil, Within, Layer, Air, Space}]] = 1 / mu0;
  nu[Magnet] = 1 / (mu0 * recoil);
  remanent[] = Vector[0, remanence, 0];
  section = (coil_outer - coil_inner) * coil_length * 1e-6;  // m2
  density[Coil] = Vector[0, 0, turns * current / section];
  // Maxwell's stress in vacuum applied to the vector $2, where B is $1
  maxwell[] = ($1 * ($1 * $2) - 0.5 * ($1 * $1) * $2) / mu0;
}

Jacobian {
  { Name Volume;
    Case {
      { Region Space; Jacobian VolAxiSquSphShell{9e-3 * size, 13e-3 * size}; }
      { Region All; Jacobian VolAxiSqu; }
    }
  }
}

Integration {
  { Name Points;
    Case { { Type Gauss; Case { { GeoElement Triangle; NumberOfPoints 12; } } } }
  }
}

Constraint {
  { Name Zero; Case { { Region Zero; Value 0; } } }
  // The weight of Maxwell's stress: 1 inside the layer, 0 beyond.
  { Name Weight; Case { { Region Within; Value 1; } { Region Air; Value 0; } } }
}

FunctionSpace {
  { Name Potential; Type Form1P;
    BasisFunction {
      { Name nodes; NameOfCoef a; Function BF_PerpendicularEdge; Support All_; Entity NodesOf[All]; }
      If(order == 2)
        { Name edges; NameOfCoef b; Function BF_PerpendicularEdge_2E; Support All_; Entity EdgesOf[All]; }
      EndIf
    }
    Constraint {
      { NameOfCoef a; EntityType NodesOf; NameOfConstraint Zero; }
      If(order == 2)
        { NameOfCoef b; EntityType EdgesOf; NameOfConstraint Zero; }
      EndIf
    }
  }
  { Name Weight; Type Form0;
    BasisFunction { { Name n; NameOfCoef g; Function BF_Node; Support Layer; Entity NodesOf[All]; } }
    Constraint { { NameOfCoef g; EntityType NodesOf; NameOfConstraint Weight; } }
  }
}

// The field, and beside it, uncoupled, the weight: harmonic, because any weight would do on an exact field and a smooth
// one asks least of the mesh.
Formulation {
  { Name Field; Type FemEquation;
    Quantity {
      { Name a; Type Local; NameOfSpace Potential; }
      { Name g; Type Local; NameOfSpace Weight; }
    }
    Equation {
      Integral { [ nu[] * Dof{d a}, {d a} ]; In All_; Jacobian Volume; Integration Points; }
      Integral { [ -nu[] * remanent[], {d a} ]; In Magnet; Jacobian Volume; Integration Points; }
      Integral { [ -density[], {a} ]; In Coil; Jacobian Volume; Integration Points; }
      Integral { [ Dof{d g}, {d g} ]; In Layer; Jacobian Volume; Integration Points; }
    }
  }
}

Resolution {
  { Name Solve;
    System { { Name Field; NameOfFormulation Field; } }
    Operation { Generate[Field]; Solve[Field]; SaveSolution[Field]; PostOperation[Forces]; }
  }
}

PostProcessing {
  { Name Field; NameOfFormulation Field;
    Quantity {
      { Name lorentz; Value { Integral { [ -2 * Pi * CompY[density[] /\ {d a}] ];
            In Coil; Jacobian Volume; Integration Points; } } }
      { Name stress; Value { Integral { [ -2 * Pi * CompY[maxwell[{d a}, {d g}]] ];
            In Layer; Jacobian Volume; Integration Points; } } }
      { Name linkage; Value { Integral { [ 2 * Pi * turns / section * CompZ[{a}] ];
            In Coil; Jacobian Volume; Integration Points; } } }
      { Name flux_density; Value { Local { [ {d a} ]; In All_; Jacobian Volume; } } }
    }
  }
}

PostOperation {
  { Name Forces; NameOfPostProcessing Field;
    Operation {
      Print[lorentz[Coil], OnGlobal, Format Table, File "forces.txt"];
      Print[stress[Layer], OnGlobal, Format Table, File > "forces.txt"];
      Print[linkage[Coil], OnGlobal, Format Table, File > "forces.txt"];
    }
  }
  // To look at: getdp pair.pro -msh pair.msh -pos Map, then gmsh flux_density.pos.
  { Name Map; NameOfPostProcessing Field;
    Operation { Print[flux_density, OnElementsOf All_, File "flux_density.pos"]; }
  }
}
)";

}  // namespace coilwright::exports
