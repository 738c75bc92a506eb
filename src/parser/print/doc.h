// parser/print: a text with choices of line breaks, and the choosing. After Wadler, "A prettier
// printer" (2003): a group is laid out flat if it fits on the line, otherwise its own line breaks
// are taken and the groups inside of it choose for themselves.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace alhazen::parser {

// A node of a document; belongs to the builder that made it.
using Doc = std::size_t;

class DocBuilder {
 public:
  DocBuilder() { text(""); }

  // Text as it is; line breaks in it stay and break the groups around it.
  Doc text(std::string text);
  // A comment after an item: as text, but nothing is broken to make room for it.
  Doc note(std::string text);
  // Flat: `flat`. Broken: a line break, and `broken` before it.
  Doc line(std::string flat, std::string broken = "");
  // A line break in any case; with a blank line before the next if `blank`.
  Doc hard(bool blank = false);
  Doc concat(std::vector<Doc> parts);
  // Line breaks inside are indented by `columns` more.
  Doc nest(int columns, Doc inside);
  // `broken`: never flat, for instance because the author broke it.
  Doc group(Doc inside, bool broken = false);
  static constexpr Doc nothing() { return 0; }

  // The document as text, without blanks at the ends of lines.
  std::string layout(Doc doc, int width) const;

 private:
  enum class Kind { text, note, line, hard, concat, nest, group };
  struct Node {
    Kind kind;
    std::string text;    // of a line: when flat
    std::string broken;  // of a line: before the break
    std::vector<Doc> parts;
    int columns = 0;          // of nest
    bool blank = false;       // of hard
    bool must_break = false;  // there is a line break inside in any case
  };
  // A node to be laid out: at this indentation, in a group that is flat or not.
  struct Step {
    Doc doc;
    int indentation;
    bool flat;
  };
  Doc add(Node node);
  bool fits(std::vector<Step> steps, const std::vector<Step>& rest, int columns) const;

  std::vector<Node> nodes_;
};

}  // namespace alhazen::parser
