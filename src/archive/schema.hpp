#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/archive/contents.hpp"

namespace coilwright::archive {

/// "Coil" in ASCII: tells our SQLite files from those of other programs.
inline constexpr std::int32_t application_id = 0x436f696c;
/// The version of the tables; a reader refuses later ones. Since version 2 every row has a checksum, since version 3
/// designs under other modelling choices have a table, and `recorded` says how many rows each table has.
inline constexpr int schema_version = 3;
inline constexpr int first_version_with_checksums = 2;
inline constexpr int first_version_with_counts = 3;

/// The tables of designs, in the order of their making.
enum class Designs { of_the_study, under_other_choices };
inline constexpr std::array<Designs, 2> tables_of_designs{Designs::of_the_study, Designs::under_other_choices};

/// "designs", "other_choices".
[[nodiscard]] std::string name_of(Designs table);

/// That of a design under this modelling choice, which is empty as the study has it.
[[nodiscard]] Designs table_of(std::string_view choice);

/// The columns of designs that every study has, in their order; the choice follows where there is one.
inline constexpr std::array<std::string_view, 10> fixed_columns{
    "id", "run", "number", "status", "failure", "infeasibility", "has_quantities", "took_s", "ended_unix_s", "origin"};

/// All tables, as SQL lists texts; only the archive of a diagnosis has the last.
inline constexpr std::string_view table_names =
    "'study', 'inputs', 'changes', 'columns', 'runs', 'designs', 'other_choices', 'recorded', 'fits'";

/// A name between double quotes, as SQL wants it.
[[nodiscard]] std::string sql_name(std::string_view name);

/// The statements that make the tables of an archive with these columns.
///
/// The columns of a study have no type, and so no affinity: SQLite keeps a double bound to them with all its bits, and
/// would make 0.0 of -0.0 in a column of type REAL.
[[nodiscard]] std::string schema_of(const std::vector<Column>& columns);

/// Those that bring the tables of version 2 to this version, of a database that has them.
[[nodiscard]] std::string later_schema_of(const std::vector<Column>& columns);

/// The columns of designs but the checksum, as SQL, in the order of the table.
[[nodiscard]] std::vector<std::string> design_columns(Designs table, const std::vector<Column>& columns);

/// "INSERT INTO designs (...) VALUES (...)" with a place for each column, in the order of the table, and the checksum
/// of what is bound to them.
[[nodiscard]] std::string insertion_of(Designs table, const std::vector<Column>& columns);

/// "UPDATE designs SET (...) = (...)" of the row of the id with the same places, where its checksum is that of what is
/// bound to them.
[[nodiscard]] std::string mending_of(Designs table, const std::vector<Column>& columns);

/// "SELECT id, run, ... FROM designs" with every column but the checksum, in the order of the table.
[[nodiscard]] std::string selection_of(Designs table, const std::vector<Column>& columns);

/// "UPDATE designs SET number = NUMBER, checksum = ..." for an SQL expression of the number: ready for a WHERE.
[[nodiscard]] std::string numbering_of(const std::vector<Column>& columns, const std::string& number);

}  // namespace coilwright::archive
