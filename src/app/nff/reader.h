// app/nff: the reader's state and its productions. Used by read*.cpp only.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "app/nff/nff_scene.h"
#include "app/nff/read.h"
#include "app/nff/token.h"
#include "core/diag/diagnostic.h"

namespace alhazen {

// A number of an entity, for messages: "the radius", "vertex" 3.
struct NffField {
  std::string_view name;
  std::size_t index = 0;  // counted from 1; 0: there is only one
};

class NffReader {
 public:
  NffReader(FileId file, const SourceManager& sources, DiagnosticSink& sink,
            const NffLimits& limits)
      : sources_(sources), sink_(sink), limits_(limits), file_(file), tokens_(file, sources) {}

  std::optional<NffScene> read();

 private:
  // What follows the keyword of an entity. False: an error was reported where it stands.
  using Production = bool (NffReader::*)();
  struct Entity {
    std::string_view keyword;
    std::string_view takes;  // for messages
    Production production;
  };
  static const std::array<Entity, 8> kEntities;
  static const Entity* find_entity(std::string_view word);

  // ---- read.cpp ---------------------------------------------------------------------------------
  void read_entity();
  void report_not_an_entity();
  void skip_to_entity();
  void check_whole();
  void report_left_out();
  bool background();
  bool light();
  bool fill();

  // ---- read_view.cpp ----------------------------------------------------------------------------
  bool view();
  bool view_part(std::string_view word);
  bool check_view(SourceSpan up);

  // ---- read_shape.cpp ---------------------------------------------------------------------------
  bool sphere();
  bool cone();
  bool polygon();
  bool patch();
  bool faces(bool with_normals);
  bool vertices(std::size_t count, bool with_normals, std::vector<Vec3d>& corners,
                std::vector<Vec3d>& normals);
  // Whether a radius, or both of a cone, are negative; noted for the warning.
  bool inside_out(bool negative);
  void check_fill();
  void add(NffShape shape);
  std::size_t fill_index();

  // ---- read_number.cpp --------------------------------------------------------------------------
  std::optional<double> number(NffField field);
  bool number(NffField field, double& value);
  bool vector(NffField field, Vec3d& value);
  // Three numbers, each at least 0.
  bool color(NffField field, Rgbd& value);
  bool at_least_zero(NffField field, double& value);
  bool whole(NffField field, std::size_t low, std::size_t high, std::size_t& value);
  // False, and reported at the number just read.
  bool out_of_range(NffField field, std::string_view range);
  std::string describe(NffField field) const;

  const SourceManager& sources_;
  DiagnosticSink& sink_;
  NffLimits limits_;
  FileId file_;
  NffTokens tokens_;
  NffScene scene_;

  NffToken keyword_;      // of the entity that is being read, or was read last
  NffToken last_number_;  // that was read
  std::optional<SourceSpan> view_at_, background_at_;
  // Words of the view: where each was found.
  std::map<std::string_view, SourceSpan> view_words_;

  std::optional<NffFill> fill_;
  std::optional<std::size_t> fill_index_;  // of fill_, once a shape wears it
  std::map<std::array<double, 8>, std::size_t> known_fills_;
  bool before_fill_reported_ = false;
  std::size_t shape_count_ = 0;
  bool too_many_ = false;

  // Warnings that may concern many shapes: the first, and how many there are.
  struct Noted {
    SourceSpan first;
    std::size_t count = 0;
    void note(SourceSpan span) {
      if (count++ == 0) first = span;
    }
  };
  Noted inside_out_, no_area_;
};

}  // namespace alhazen
