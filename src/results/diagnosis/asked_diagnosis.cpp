#include "coilwright/results/diagnosis/asked_diagnosis.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>
#include <utility>

#include "coilwright/measurement/records/record_slip.hpp"
#include "coilwright/measurement/require_no_slip.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::results {
namespace {

// The data set, the declared actuator, and every record.
Provenance provenance_of(const formats::DatasetFile& set, const std::filesystem::path& declared, std::uint64_t seed) {
  Provenance provenance{.command = "diagnose", .inputs = {record_of(set.file), record_of(declared)}, .seed = seed};
  for (const std::filesystem::path& run : set.run_files) provenance.inputs.push_back(record_of(run));
  return provenance;
}

std::filesystem::path declared_path(const std::optional<std::filesystem::path>& given,
                                    const formats::DatasetFile& set) {
  if (given) return *given;
  if (set.actuator && std::filesystem::exists(*set.actuator)) return *set.actuator;
  if (set.actuator)
    throw text::InputError({.file = set.file,
                            .place = "/actuator",
                            .rule = "must name a file, from the folder of the data set on, or be given by --actuator",
                            .value = fmt::format("{}, which is not there", set.actuator->string())});
  throw text::InputError({.file = set.file, .rule = "names no \"actuator\"; one must be given with --actuator"});
}

// A set that does not fit its model, or a model that cannot be simulated, counts as bad data.
template <typename Work>
auto blaming_files(const AskedDiagnosis& asked, const Work& work) {
  try {
    return work();
  } catch (const measurement::records::RecordSlip& slip) {
    throw text::InputError(
        {.file = asked.set.file, .rule = fmt::format("{}; --as-written takes it as it is", slip.what())});
  } catch (const std::invalid_argument& misfit) {
    throw text::InputError({.file = asked.set.file, .rule = misfit.what()});
  } catch (const std::system_error&) {
    throw;  // of the machine
  } catch (const std::domain_error& range) {
    throw text::InputError({.file = asked.declared_file.string(), .rule = range.what()});
  } catch (const std::runtime_error& lost) {
    throw text::InputError({.file = asked.declared_file.string(), .rule = lost.what()});
  }
}

}  // namespace

AskedDiagnosis read_asked(const std::filesystem::path& dataset, const std::optional<std::filesystem::path>& actuator,
                          std::uint64_t seed, const actuator::EffectCatalogue& effects) {
  formats::DatasetFile set = formats::read_dataset(dataset, effects);
  std::filesystem::path declared_file = declared_path(actuator, set);
  formats::DeclaredActuator declared = formats::read_declared_actuator(
      declared_file, {.names = set.calibrate, .file = set.file, .tolerances = set.tolerances}, effects);
  Provenance provenance = provenance_of(set, declared_file, seed);
  return {.set = std::move(set),
          .declared_file = std::move(declared_file),
          .declared = std::move(declared),
          .provenance = std::move(provenance),
          .effects = effects};
}

measurement::Diagnosis diagnose(const AskedDiagnosis& asked, measurement::DiagnosisOptions how) {
  how.effects = asked.effects;
  how.beliefs = asked.set.beliefs;
  how.seed = asked.provenance.seed.value_or(how.seed);
  return blaming_files(asked, [&] { return measurement::diagnose(asked.set.data, asked.declared.model, how); });
}

void require_no_slip(const AskedDiagnosis& asked) {
  blaming_files(asked, [&] { measurement::require_no_slip(asked.set.data, asked.declared.model); });
}

}  // namespace coilwright::results
