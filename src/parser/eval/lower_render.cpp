// parser/eval: the settings.
#include <fmt/format.h>

#include "parser/eval/lower.h"

namespace alhazen::parser {
namespace {

ReconstructionFilter lower_filter(const Properties& p) {
  const std::string word = p.word("filter");
  ReconstructionFilter filter{FilterKind::box, 0.5};
  if (word == "tent") filter = {FilterKind::tent, 1};
  if (word == "gaussian") filter = {FilterKind::gaussian, 1.5};
  if (word == "mitchell") filter = {FilterKind::mitchell, 2};
  if (p.has("filter_radius")) filter.radius = p.number("filter_radius");
  return filter;
}

// False, with a complaint, where the block also says what is then chosen by itself.
bool lower_max_error(Context& context, const Properties& p, RenderSettings& out) {
  if (p.has("max_error_share") && !p.has("max_error")) {
    context.report<DiagnosticKind::needs_other_property>(p.find("max_error_share")->name_span,
                                                         "max_error_share", "max_error");
    return false;
  }
  if (!p.has("max_error")) return true;
  for (const char* other : {"samples", "adaptive", "min_samples", "depth", "cutoff"}) {
    if (!p.has(other)) continue;
    context
        .report<DiagnosticKind::one_or_the_other>(p.find(other)->name_span, "render", "max_error",
                                                  other)
        .label(p.find("max_error")->name_span, "`max_error` is here")
        .hint("`max_error` chooses samples, depth and cutoff by itself");
    return false;
  }
  out.max_error = ErrorTarget{p.number("max_error"), 0};
  if (p.has("max_error_share")) out.max_error->share = p.number("max_error_share");
  return true;
}

}  // namespace

std::optional<RenderSettings> lower_render(Context& context, const Properties& p) {
  RenderSettings out;
  out.width = static_cast<int>(p.vec2("size").x);
  out.height = static_cast<int>(p.vec2("size").y);
  out.samples = static_cast<int>(p.number("samples"));
  if (!lower_max_error(context, p, out)) return std::nullopt;
  if (p.has("min_samples") && !p.has("adaptive")) {
    context.report<DiagnosticKind::needs_other_property>(p.find("min_samples")->name_span,
                                                         "min_samples", "adaptive");
    return std::nullopt;
  }
  if (p.has("adaptive")) {
    AdaptiveSampling adaptive;
    adaptive.threshold = p.number("adaptive");
    if (p.has("min_samples")) adaptive.min_samples = static_cast<int>(p.number("min_samples"));
    if (!p.has("samples")) out.samples = kAdaptiveSamples;
    if (out.samples <= adaptive.min_samples) {
      context
          .report<DiagnosticKind::samples_not_above_minimum>(
              p.span(p.has("samples") ? "samples" : "min_samples"), out.samples,
              adaptive.min_samples)
          .hint("`samples` is the most and `min_samples` the fewest that a pixel takes");
      return std::nullopt;
    }
    out.adaptive = adaptive;
  }
  out.max_depth = static_cast<int>(p.number("depth"));
  out.cutoff = p.number("cutoff");
  out.filter = lower_filter(p);
  out.transparent_background = p.boolean("transparent_background");
  out.seed = static_cast<std::uint64_t>(p.number("seed"));
  out.span = p.head();
  return out;
}

}  // namespace alhazen::parser
