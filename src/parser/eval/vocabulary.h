// parser/eval: the names of a scene, each with what it means, looked up once. A loop meets the same
// few names a million times: comparing texts, table by table, took a sixth of its time.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "parser/eval/builtin/builtin.h"
#include "parser/eval/schema/schema.h"

namespace alhazen::parser {

// What stands for a name as an item: `sphere { ... }`, `group { ... }`.
enum class Placeable { no, shape, group, object, light };

// One spelling. Two names are the same if and only if they are the same Word.
class Word {
 public:
  explicit Word(std::string_view text);

  std::string_view text;
  // What it means where the author has not defined it; null or `no` where it is not that.
  const BuiltinConstant* constant;
  const BuiltinFunction* function;
  const BlockSchema* kind;   // `name { ... }` as an expression makes one of this
  const BlockSchema* shape;  // of a placeable shape
  Placeable placeable;
  // Whether any scope has had it so far: most names in a scene are built in, and no scope has them.
  bool defined = false;

  // The property of that name; null if the schema has none.
  const PropertySpec* property_of(const BlockSchema& schema) {
    for (const Known& known : properties_) {
      if (known.schema == &schema) return known.spec;
    }
    properties_.push_back({&schema, schema.find(text)});
    return properties_.back().spec;
  }

 private:
  struct Known {
    const BlockSchema* schema;
    const PropertySpec* spec;
  };
  std::vector<Known> properties_;  // of the schemas that were asked for
};

class Vocabulary {
 public:
  // Precondition: `name` is a view of a text of the scene, whose bytes stay as they are.
  Word& operator[](std::string_view name) {
    Place& place = places_[reinterpret_cast<std::uintptr_t>(name.data()) % kPlaces];
    if (place.begin != name.data() || place.word->text.size() != name.size()) {
      place = {name.data(), &look_up(name)};
    }
    return *place.word;
  }

 private:
  // A name that stands at one place of the text is always the same: the body of a loop needs no
  // hash of it. Bodies of fewer bytes than this keep out of each other's way.
  static constexpr std::size_t kPlaces = 1024;
  struct Place {
    const char* begin = nullptr;
    Word* word = nullptr;
  };

  Word& look_up(std::string_view name);

  std::array<Place, kPlaces> places_{};
  std::unordered_map<std::string_view, Word> words_;
};

}  // namespace alhazen::parser
