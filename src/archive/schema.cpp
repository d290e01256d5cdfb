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
CREATE TABLE designs (
  id INTEGER PRIMARY KEY, run INTEGER NOT NULL, number INTEGER, status TEXT NOT NULL, failure TEXT,
  infeasibility, has_quantities INTEGER NOT NULL, took_s, ended_unix_s, origin TEXT)";

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

std::string schema_of(const std::vector<Column>& columns) {
  std::string text(tables);
  for (const Column& column : columns) text += ", " + sql_name(column.column);
  return text + ", checksum INTEGER);\n" +
         fmt::format("PRAGMA application_id = {};\nPRAGMA user_version = {};\n", application_id, schema_version);
}

std::vector<std::string> design_columns(const std::vector<Column>& columns) {
  std::vector<std::string> names(fixed_columns.begin(), fixed_columns.end());
  for (const Column& column : columns) names.push_back(sql_name(column.column));
  return names;
}

std::string mending_of(const std::vector<Column>& columns) {
  const std::vector<std::string> names = design_columns(columns), places = places_of(names);
  return fmt::format("UPDATE designs SET ({}) = ({}) WHERE id = ?1 AND checksum = {}", fmt::join(names, ", "),
                     fmt::join(places, ", "), checksum_sql(places));
}

std::string insertion_of(const std::vector<Column>& columns) {
  const std::vector<std::string> names = design_columns(columns), places = places_of(names);
  return fmt::format("INSERT INTO designs ({}, checksum) VALUES ({}, {})", fmt::join(names, ", "),
                     fmt::join(places, ", "), checksum_sql(places));
}

std::string selection_of(const std::vector<Column>& columns) {
  return fmt::format("SELECT {} FROM designs", fmt::join(design_columns(columns), ", "));
}

std::string numbering_of(const std::vector<Column>& columns, const std::string& number) {
  std::vector<std::string> values = design_columns(columns);
  std::ranges::replace(values, std::string("number"), number);
  return fmt::format("UPDATE designs SET number = {}, checksum = {}", number, checksum_sql(values));
}

}  // namespace coilwright::archive
