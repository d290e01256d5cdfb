#pragma once

namespace coilwright::thermal {

/// Thermal class 155 (F) of the common solderable polyurethane enamel (NEMA MW 79-C, IEC 60317-20), degC. Reasons for
/// this class: docs/theory/thermal.md, "The film".
inline constexpr double class_f_enamel_limit = 155.0;

/// Highest working temperature of a neodymium magnet whose grade carries no letter (N35 to N52), degC; above it some
/// magnetisation is lost for good. A guide of the makers (supermagnete, "Physical magnet data"): a thin disc in a
/// demagnetising field, as of a repelling coil, may lose it earlier.
inline constexpr double n_grade_magnet_limit = 80.0;

}  // namespace coilwright::thermal
