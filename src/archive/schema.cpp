#include "archive/schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>

#include "archive/checksum.hpp"

namespace coilwright::archive {
namespace {

constexpr std::string_view tables = R"(
CREATE TABLE study (
  command TEXT NOT NULL, name TEXT NOT NULL, question_sha256 TEXT NOT NULL, algorithm TEXT NOT NULL, seed INTEGER,
  version TEXT NOT NULL, commit_hash TEXT NOT NULL, build_sha256 TEXT NOT NULL, actuator_sha256 TEXT NOT NULL,
  operation_sha256 TEXT NOT NULL, systems_sha256 TEXT NOT NULL, checksum INTEGER);
CREATE TABLE inputs (
  position INTEGER PRIMARY KEY, file TEXT NOT NULL, sha256 TEXT NOT NULL, content BLOB NOT NULL, checksum INTEGER);
CREATE TABLE changes (position INTEGER PRIMARY KEY, change TEXT NOT NULL, checksum INTEGER);
CREATE TABLE columns (
  position INTEGER PRIMARY KEY, role TEXT NOT NULL, name TEXT NOT NULL, meaning TEXT NOT NULL,
  column_name TEXT NOT NULL, checksum INTEGER);
CREATE TABLE runs (
  run INTEGER PRIMARY KEY, started_utc TEXT NOT NULL, ended_utc TEXT, stop_reason TEXT, max_evaluations INTEGER,
  evaluated INTEGER NOT NULL DEFAULT 0, answered INTEGER NOT NULL DEFAULT 0, reused INTEGER NOT NULL DEFAULT 0, checksum INTEGER);
)";

constexpr std::string_view table_of_designs = R"(
CREATE TABLE {} (
  id INTEGER PRIMARY KEY, run INTEGER NOT NULL, number INTEGER, status TEXT NOT NULL, failure TEXT,
  infeasibility, has_quantities INTEGER NOT NULL, took_s, ended_unix_s, origin TEXT{}{}, checksum INTEGER);
)";

constexpr std::string_view table_of_counts = R"(
CREATE TABLE recorded (position INTEGER PRIMARY KEY, name TEXT NOT NULL, rows INTEGER NOT NULL, checksum INTEGER);
)";

std::string table_of(Designs table, const std::vector<Column>& columns) {
  std::string names;
  for (const Column& column : columns) names += ", " + sql_name(column.column);
  return fmt::format(table_of_designs, name_of(table), table == Designs::of_the_study ? "" : ", choice TEXT NOT NULL",
                     names);
}

std::vector<std::string> places_of(const std::vector<std::string>& names) {
  std::vector<std::string> places;
  for (std::size_t i = 1; i <= names.size(); ++i) places.push_back(fmt::format("?{}", i));
  return places;
}

}  // namespace

std::string sql_name(std::string_view name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

std::string name_of(Designs table) {
  return table == Designs::of_the_study ? "designs" : "other_choices";
}

Designs table_of(std::string_view choice) {
  return choice.empty() ? Designs::of_the_study : Designs::under_other_choices;
}

std::string schema_of(const std::vector<Column>& columns) {
  return std::string(tables) + table_of(Designs::of_the_study, columns) + later_schema_of(columns) +
         fmt::format("PRAGMA application_id = {};\n", application_id);
}

std::string later_schema_of(const std::vector<Column>& columns) {
  return table_of(Designs::under_other_choices, columns) + std::string(table_of_counts) +
         fmt::format("PRAGMA user_version = {};\n", schema_version);
}

std::vector<std::string> design_columns(Designs table, const std::vector<Column>& columns) {
  std::vector<std::string> names(fixed_columns.begin(), fixed_columns.end());
  if (table == Designs::under_other_choices) names.emplace_back("choice");
  for (const Column& column : columns) names.push_back(sql_name(column.column));
  return names;
}

std::string mending_of(Designs table, const std::vector<Column>& columns) {
  const std::vector<std::string> names = design_columns(table, columns), places = places_of(names);
  return fmt::format("UPDATE {} SET ({}) = ({}) WHERE id = ?1 AND checksum = {}", name_of(table),
                     fmt::join(names, ", "), fmt::join(places, ", "), checksum_sql(places));
}

std::string insertion_of(Designs table, const std::vector<Column>& columns) {
  const std::vector<std::string> names = design_columns(table, columns), places = places_of(names);
  return fmt::format("INSERT INTO {} ({}, checksum) VALUES ({}, {})", name_of(table), fmt::join(names, ", "),
                     fmt::join(places, ", "), checksum_sql(places));
}

std::string selection_of(Designs table, const std::vector<Column>& columns) {
  return fmt::format("SELECT {} FROM {}", fmt::join(design_columns(table, columns), ", "), name_of(table));
}

std::string numbering_of(const std::vector<Column>& columns, const std::string& number) {
  std::vector<std::string> values = design_columns(Designs::of_the_study, columns);
  std::ranges::replace(values, std::string("number"), number);
  return fmt::format("UPDATE designs SET number = {}, checksum = {}", number, checksum_sql(values));
}

}  // namespace coilwright::archive
