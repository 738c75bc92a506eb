// app/nff: from the text of an NFF file to NffScene.
#pragma once

#include <cstddef>
#include <optional>

#include "app/nff/nff_scene.h"
#include "core/diag/diagnostic.h"

namespace alhazen {

// An NFF file is untrusted input: each of these ends in an error.
struct NffLimits {
  std::size_t shapes = 1'000'000;       // after triangulation, with lights and runs of one fill
  std::size_t polygon_vertices = 4096;  // triangulation takes quadratic time
};

// Reads by words: where lines break makes no difference. Errors and warnings go to `sink`, with the
// word that is wrong as their place; the scene is there if and only if no error was reported.
std::optional<NffScene> read_nff(FileId file, const SourceManager& sources, DiagnosticSink& sink,
                                 const NffLimits& limits = {});

}  // namespace alhazen
