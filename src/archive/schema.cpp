#include "archive/schema.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace coilwright::archive {
namespace {

constexpr std::string_view tables = R"(
CREATE TABLE study (
  command TEXT NOT NULL, name TEXT NOT NULL, question_sha256 TEXT NOT NULL, algorithm TEXT NOT NULL, seed INTEGER,
  version TEXT NOT NULL, commit_hash TEXT NOT NULL, build_sha256 TEXT NOT NULL, actuator_sha256 TEXT NOT NULL,
  operation_sha256 TEXT NOT NULL, systems_sha256 TEXT NOT NULL);
CREATE TABLE inputs (
  position INTEGER PRIMARY KEY, file TEXT NOT NULL, sha256 TEXT NOT NULL, content BLOB NOT NULL);
CREATE TABLE changes (position INTEGER PRIMARY KEY, change TEXT NOT NULL);
CREATE TABLE columns (
  position INTEGER PRIMARY KEY, role TEXT NOT NULL, name TEXT NOT NULL, meaning TEXT NOT NULL,
  column_name TEXT NOT NULL);
CREATE TABLE runs (
  run INTEGER PRIMARY KEY, started_utc TEXT NOT NULL, ended_utc TEXT, stop_reason TEXT, max_evaluations INTEGER,
  evaluated INTEGER NOT NULL DEFAULT 0, answered INTEGER NOT NULL DEFAULT 0, reused INTEGER NOT NULL DEFAULT 0);
CREATE TABLE designs (
  id INTEGER PRIMARY KEY, run INTEGER NOT NULL, number INTEGER, status TEXT NOT NULL, failure TEXT,
  infeasibility, has_quantities INTEGER NOT NULL, took_s, ended_unix_s, origin TEXT)";

}  // namespace

std::string sql_name(std::string_view name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

std::string schema_of(const std::vector<Column>& columns) {
  std::string text(tables);
  for (const Column& column : columns) text += ", " + sql_name(column.column);
  return text + ");\n" +
         fmt::format("PRAGMA application_id = {};\nPRAGMA user_version = {};\n", application_id, schema_version);
}

std::string insertion_of(const std::vector<Column>& columns) {
  std::string names, places;
  for (std::size_t i = 1; i < fixed_columns.size(); ++i) {
    names += fmt::format("{}{}", i > 1 ? ", " : "", fixed_columns[i]);
    places += i > 1 ? ", ?" : "?";
  }
  for (const Column& column : columns) {
    names += ", " + sql_name(column.column);
    places += ", ?";
  }
  return fmt::format("INSERT INTO designs ({}) VALUES ({})", names, places);
}

std::string selection_of(const std::vector<Column>& columns) {
  std::string names;
  for (const std::string_view name : fixed_columns) names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
  for (const Column& column : columns) names += ", " + sql_name(column.column);
  return fmt::format("SELECT {} FROM designs", names);
}

}  // namespace coilwright::archive
