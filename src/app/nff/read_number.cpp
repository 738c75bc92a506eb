// app/nff: numbers of entities, and what is said when they are not there.
#include <cmath>
#include <fmt/format.h>

#include "app/nff/reader.h"

namespace alhazen {

std::string NffReader::describe(NffField field) const {
  const std::string index = field.index > 0 ? fmt::format(" {}", field.index) : "";
  return fmt::format("{}{} of `{}`", field.name, index, keyword_.text);
}

std::optional<double> NffReader::number(NffField field) {
  const NffNumber read = read_nff_number(tokens_.peek().text);
  switch (read.state) {
    case NffNumberState::not_a_number:
      sink_
          .report<DiagnosticKind::import_expected>(tokens_.peek().span,
                                                   "a number for " + describe(field),
                                                   alhazen::describe(tokens_.peek()))
          .label(keyword_.span, "this entity");
      return std::nullopt;
    case NffNumberState::too_large:
      sink_.report<DiagnosticKind::import_number_too_large>(tokens_.peek().span,
                                                            tokens_.peek().text);
      return std::nullopt;
    case NffNumberState::good:
      break;
  }
  last_number_ = tokens_.take();
  return read.value;
}

bool NffReader::number(NffField field, double& value) {
  const auto read = number(field);
  if (read) value = *read;
  return read.has_value();
}

bool NffReader::vector(NffField field, Vec3d& value) {
  return number(field, value.x) && number(field, value.y) && number(field, value.z);
}

bool NffReader::at_least_zero(NffField field, double& value) {
  return number(field, value) && (value >= 0 || out_of_range(field, "at least 0"));
}

bool NffReader::color(NffField field, Rgbd& value) {
  return at_least_zero(field, value.r) && at_least_zero(field, value.g) &&
         at_least_zero(field, value.b);
}

bool NffReader::whole(NffField field, std::size_t low, std::size_t high, std::size_t& value) {
  const auto read = number(field);
  if (!read) return false;
  if (*read != std::floor(*read) || *read < static_cast<double>(low) ||
      *read > static_cast<double>(high)) {
    return out_of_range(field, fmt::format("a whole number from {} to {}", low, high));
  }
  value = static_cast<std::size_t>(*read);
  return true;
}

bool NffReader::out_of_range(NffField field, std::string_view range) {
  sink_.report<DiagnosticKind::import_out_of_range>(last_number_.span, describe(field), range,
                                                    last_number_.text);
  return false;
}

}  // namespace alhazen
