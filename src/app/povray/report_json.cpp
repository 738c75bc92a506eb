// app/povray: the outcome of cross-checks as data.
#include <nlohmann/json.hpp>

#include "app/povray/report_page.h"

namespace alhazen {
namespace {

using Json = nlohmann::ordered_json;

Json pixel_json(const JudgedPixel& p) {
  return {{"x", p.place.column},
          {"y", p.place.row},
          {"cause", name(p.cause)},
          {"ours", {p.ours.r, p.ours.g, p.ours.b}},
          {"theirs", {p.theirs.r, p.theirs.g, p.theirs.b}}};
}

Json witness_json(const Witness& w) {
  Json pixels = Json::array();
  for (const JudgedPixel& p : w.verdict.pixels)
    pixels.push_back(pixel_json(p));
  return {{"witness", w.name},
          {"same", w.verdict.passes},
          {"sentence", w.verdict.sentence},
          {"channels", w.verdict.channels},
          {"channels_over", w.verdict.over},
          {"rmse", w.verdict.rmse},
          {"largest", w.verdict.largest},
          {"povray_trace_seconds", w.run.trace_seconds},
          {"povray_wall_seconds", w.run.wall_seconds},
          {"povray_cpu_seconds", w.run.cpu_seconds},
          {"pixels", std::move(pixels)}};
}

Json outcome_json(const CheckOutcome& outcome) {
  if (!outcome.check) {
    return {{"scene", outcome.name}, {"same", false}, {"error", outcome.check.error().message}};
  }
  const CrossCheck& check = outcome.check.value();
  Json witnesses = Json::array();
  for (const Witness& w : check.witnesses)
    witnesses.push_back(witness_json(w));
  return {{"scene", check.name},
          {"same", check.passes()},
          {"render_seconds", check.our_seconds},
          {"deviations", check.deviation_texts},
          {"witnesses", std::move(witnesses)}};
}

}  // namespace

std::string report_json(const std::vector<CheckOutcome>& outcomes) {
  Json out = {{"scenes", Json::array()}};
  for (const CheckOutcome& outcome : outcomes)
    out["scenes"].push_back(outcome_json(outcome));
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace alhazen
