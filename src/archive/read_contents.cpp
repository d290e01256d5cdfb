#include "archive/read_contents.hpp"

#include <array>
#include <string>

#include "coilwright/text/one_line.hpp"

namespace coilwright::archive {
namespace {

Role role_named(const std::string& name) {
  for (const Role role : {Role::variable, Role::objective, Role::constraint, Role::quantity})
    if (name == name_of(role)) return role;
  throw SQLite::Exception("the role \"" + name + "\" of a column is unknown");
}

// What is printed, of a file that anybody may have written.
std::string line_of(const SQLite::Column& cell) {
  return text::one_line(cell.getString(), 10'000);
}

std::string bytes_of(const SQLite::Column& cell) {
  const auto* bytes = static_cast<const char*>(cell.getBlob());
  return bytes == nullptr ? std::string() : std::string(bytes, static_cast<std::size_t>(cell.getBytes()));
}

void read_study(SQLite::Database& database, Contents& contents) {
  SQLite::Statement study(database,
                          "SELECT command, name, question_sha256, algorithm, seed, version, commit_hash, build_sha256, "
                          "actuator_sha256, operation_sha256, systems_sha256 FROM study");
  if (!study.executeStep()) throw SQLite::Exception("it does not say which study it is of");
  contents.command = line_of(study.getColumn(0));
  contents.study = line_of(study.getColumn(1));
  contents.question = line_of(study.getColumn(2));
  contents.algorithm = line_of(study.getColumn(3));
  if (!study.isColumnNull(4)) contents.seed = static_cast<std::uint64_t>(study.getColumn(4).getInt64());
  contents.program = {.version = line_of(study.getColumn(5)),
                      .commit = line_of(study.getColumn(6)),
                      .build = line_of(study.getColumn(7))};
  contents.physics = {.actuator = study.getColumn(8).getString(),
                      .operation = study.getColumn(9).getString(),
                      .systems = study.getColumn(10).getString()};
}

}  // namespace

std::vector<Column> read_columns(SQLite::Database& database) {
  std::vector<Column> columns;
  SQLite::Statement rows(database, "SELECT role, name, meaning, column_name FROM columns ORDER BY position");
  while (rows.executeStep())
    columns.push_back({.role = role_named(rows.getColumn(0).getString()),
                       .name = rows.getColumn(1).getString(),
                       .meaning = rows.getColumn(2).getString(),
                       .column = rows.getColumn(3).getString()});
  return columns;
}

Contents read_contents(SQLite::Database& database) {
  Contents contents;
  read_study(database, contents);
  SQLite::Statement inputs(database, "SELECT file, sha256, content FROM inputs ORDER BY position");
  while (inputs.executeStep())
    contents.inputs.push_back({.file = line_of(inputs.getColumn(0)),
                               .sha256 = line_of(inputs.getColumn(1)),
                               .text = bytes_of(inputs.getColumn(2))});
  SQLite::Statement changes(database, "SELECT change FROM changes ORDER BY position");
  while (changes.executeStep()) contents.changes.push_back(line_of(changes.getColumn(0)));
  contents.columns = read_columns(database);
  return contents;
}

}  // namespace coilwright::archive
