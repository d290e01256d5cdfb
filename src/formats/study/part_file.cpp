#include "coilwright/formats/study/part_file.hpp"

#include <fmt/format.h>

#include <utility>

#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

using text::Json;
using text::Node;
using text::ObjectReader;

namespace {

Json whole_json(const archive::Contents& whole) {
  Json inputs = Json::list(whole.inputs, [](const archive::Input& input) {
    return Json::object({{"file", input.file}, {"sha256", input.sha256}, {"content", input.text}});
  });
  return Json::object({{"command", whole.command},
                       {"study", whole.study},
                       {"version", whole.program.version},
                       {"commit", whole.program.commit},
                       {"build_sha256", whole.program.build},
                       {"inputs", std::move(inputs)},
                       {"set", Json::list(whole.changes)},
                       {"options", whole.algorithm},
                       {"seed", whole.seed}});
}

archive::Contents read_whole(const Node& node) {
  return text::read_object(node, [](ObjectReader& in) {
    archive::Contents out{.command = in.text("command"), .study = in.text("study")};
    out.program = {.version = in.text("version"), .commit = in.text("commit"), .build = in.text("build_sha256")};
    for (const Node& each : in.elements("inputs"))
      out.inputs.push_back(text::read_object(each, [](ObjectReader& input) {
        return archive::Input{
            .file = input.text("file"), .sha256 = input.text("sha256"), .text = input.text("content")};
      }));
    for (const Node& each : in.elements("set")) out.changes.push_back(each.text());
    out.algorithm = in.text("options");
    if (const auto seed = in.find_not_null("seed")) out.seed = seed->integer<std::uint64_t>(text::non_negative);
    return out;
  });
}

Machine read_machine(const Node& node) {
  return text::read_object(node, [](ObjectReader& in) {
    return Machine{
        .host = in.text("host"), .processor = in.text("processor"), .figures = in.at("figures").value().text()};
  });
}

Json machine_json(const Machine& machine) {
  return Json::object({{"host", machine.host},
                       {"processor", machine.processor},
                       {"figures", text::parse_json(machine.figures, "figures").root().value()}});
}

FileOfPart read_file_of_part(const Node& node) {
  return text::read_object(node, [](ObjectReader& in) {
    const Node name = in.at("file");
    FileOfPart out{.name = name.text(),
                   .bytes = in.integer<std::uintmax_t>("bytes", text::non_negative),
                   .sha256 = in.text("sha256")};
    const std::filesystem::path plain(out.name);
    if (plain.filename() != plain || plain.empty() || out.name == "." || out.name == "..")
      throw name.error("must be the name of a file in this folder");
    return out;
  });
}

Json exact_total_json(const sizing::QuantityTotal& total) {
  return Json::object({{"designs", total.designs},
                       {"sum_in_2_to_-1074", total.sum.text()},
                       {"least", total.least},
                       {"greatest", total.greatest}});
}

sizing::QuantityTotal read_exact_total(const Node& node) {
  return text::read_object(node, [](ObjectReader& in) {
    return sizing::QuantityTotal{.designs = in.integer<std::size_t>("designs", text::non_negative),
                                 .sum = sizing::ExactSum(in.text("sum_in_2_to_-1074")),
                                 .least = in.number("least"),
                                 .greatest = in.number("greatest")};
  });
}

Json sample_of_part(const sizing::DesignSample& sample) {
  return Json::object({{"sampling", sizing::name_of(sample.sampling)}, {"drawn", sample.drawn}, {"seed", sample.seed}});
}

sizing::DesignSample read_sample_of_part(const Node& node) {
  return text::read_object(node, [](ObjectReader& in) {
    return sizing::DesignSample{.sampling = in.at("sampling").choice_among<sizing::Sampling>(sizing::sampling_words),
                                .drawn = in.integer<std::size_t>("drawn", text::non_negative),
                                .seed = in.integer<std::uint64_t>("seed", text::non_negative)};
  });
}

Json exact_design_json(const sizing::SweptDesign& design) {
  const sizing::Evaluation& evaluation = design.evaluation;
  return Json::object({{"index", design.index},
                       {"point", Json::numbers(design.point)},
                       {"objectives", Json::numbers(evaluation.objectives)},
                       {"constraints", Json::numbers(evaluation.constraints)},
                       {"failure", evaluation.failure},
                       {"infeasibility", evaluation.infeasibility},
                       {"quantities", Json::list(evaluation.quantities)}});
}

sizing::SweptDesign read_exact_design(const Node& node) {
  return text::read_object(node, [](ObjectReader& in) {
    sizing::SweptDesign out{
        .index = in.integer<std::size_t>("index", text::non_negative), .point = in.numbers("point"), .evaluation = {}};
    out.evaluation = {.objectives = in.numbers("objectives"),
                      .constraints = in.numbers("constraints"),
                      .failure = in.text("failure"),
                      .infeasibility = in.number("infeasibility")};
    for (const Node& each : in.elements("quantities"))
      out.evaluation.quantities.push_back(each.is_null() ? std::nullopt : std::optional(each.number()));
    return out;
  });
}

Json designs_json(std::span<const sizing::SweptDesign> designs) {
  return Json::list(designs, exact_design_json);
}

std::vector<sizing::SweptDesign> read_designs(const Node& node) {
  std::vector<sizing::SweptDesign> out;
  for (const Node& each : node.elements()) out.push_back(read_exact_design(each));
  return out;
}

}  // namespace

std::string Machine::name() const {
  return fmt::format("{} ({})", host, processor);
}

Json to_json(const PartFile& part) {
  return Json::object({{"format", "part/1"},
                       {"part", part.part.number},
                       {"of", part.part.of},
                       {"whole", whole_json(part.whole)},
                       {"machine", machine_json(part.machine)},
                       {"files", Json::list(part.files, [](const FileOfPart& file) {
                          return Json::object({{"file", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
                        })}});
}

Json found_json(const std::string& part_sha256, Json results) {
  return Json::object({{"part_sha256", part_sha256}, {"results", std::move(results)}});
}

Node results_in(const text::Document& found, const std::string& part_sha256) {
  return text::read_object(found.root(), [&](ObjectReader& in) {
    if (in.text("part_sha256") != part_sha256)
      throw found.root().error_without_value("belongs to another part.json than stands beside it: make the part again");
    return in.at("results");
  });
}

Json to_json(const Machine& machine) {
  return Json::object({{"format", "head/1"}, {"machine", machine_json(machine)}});
}

PartFile read_part(const std::filesystem::path& path) {
  const text::Document document = text::read_json(path);
  return text::read_object(document.root(), [](ObjectReader& in) {
    in.literal("format", "part/1");
    const auto of = in.integer<std::size_t>("of", text::Rule::between(1, sizing::most_parts_of_a_run));
    const auto number = in.integer<std::size_t>("part", text::Rule::between(1, static_cast<double>(of)));
    PartFile out{.part = {.number = number, .of = of},
                 .whole = read_whole(in.at("whole")),
                 .machine = read_machine(in.at("machine"))};
    for (const Node& each : in.elements("files")) out.files.push_back(read_file_of_part(each));
    return out;
  });
}

Machine read_head(const std::filesystem::path& path) {
  const text::Document document = text::read_json(path);
  return text::read_object(document.root(), [](ObjectReader& in) {
    in.literal("format", "head/1");
    return read_machine(in.at("machine"));
  });
}

Json to_json(const SweepPart& part) {
  return Json::object({{"count", part.count},
                       {"kept", sizing::name_of(part.keep)},
                       {"sample", part.sample ? sample_of_part(*part.sample) : Json(nullptr)},
                       {"ok", part.totals.ok},
                       {"quantities", Json::list(part.totals.quantities, exact_total_json)},
                       {"best", designs_json(part.kept)}});
}

SweepPart read_sweep_part(const Node& results) {
  return text::read_object(results, [](ObjectReader& in) {
    SweepPart out{.count = in.integer<std::size_t>("count", text::non_negative),
                  .keep = in.at("kept").choice_among<sizing::Keep>(sizing::keep_words)};
    if (const auto sample = in.find_not_null("sample")) out.sample = read_sample_of_part(*sample);
    out.totals.ok = in.integer<std::size_t>("ok", text::non_negative);
    for (const Node& each : in.elements("quantities")) out.totals.quantities.push_back(read_exact_total(each));
    out.kept = read_designs(in.at("best"));
    return out;
  });
}

Json to_json(const SearchPart& part) {
  return Json::object(
      {{"stop_reason", part.stop_reason}, {"evaluations", part.evaluations}, {"found", designs_json(part.found)}});
}

SearchPart read_search_part(const Node& results) {
  return text::read_object(results, [](ObjectReader& in) {
    return SearchPart{.stop_reason = in.text("stop_reason"),
                      .evaluations = in.integer<std::size_t>("evaluations", text::non_negative),
                      .found = read_designs(in.at("found"))};
  });
}

Json to_json(const YieldPart& part) {
  return Json::object({{"builds", part.builds}, {"worth_builds", part.worth_builds}, {"current_A", part.current}});
}

YieldPart read_yield_part(const Node& results) {
  return text::read_object(results, [](ObjectReader& in) {
    YieldPart out{.builds = in.integer<std::size_t>("builds", text::non_negative),
                  .worth_builds = in.integer<std::size_t>("worth_builds", text::non_negative)};
    if (const auto current = in.find_not_null("current_A")) out.current = current->number();
    return out;
  });
}

}  // namespace coilwright::formats
