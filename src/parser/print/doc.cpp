#include "parser/print/doc.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace alhazen::parser {
namespace {

// In code points, as a person counts columns.
int columns_of(std::string_view text) {
  return static_cast<int>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

}  // namespace

Doc DocBuilder::add(Node node) {
  for (const Doc part : node.parts)
    node.must_break = node.must_break || nodes_[part].must_break;
  nodes_.push_back(std::move(node));
  return nodes_.size() - 1;
}

Doc DocBuilder::text(std::string text) {
  const bool lines = text.find('\n') != std::string::npos;
  return add({Kind::text, std::move(text), "", {}, 0, false, lines});
}
Doc DocBuilder::note(std::string text) {
  return add({Kind::note, std::move(text), "", {}, 0, false, true});
}
Doc DocBuilder::line(std::string flat, std::string broken) {
  return add({Kind::line, std::move(flat), std::move(broken), {}, 0, false, false});
}
Doc DocBuilder::hard(bool blank) {
  return add({Kind::hard, "", "", {}, 0, blank, true});
}
Doc DocBuilder::concat(std::vector<Doc> parts) {
  return add({Kind::concat, "", "", std::move(parts), 0, false, false});
}
Doc DocBuilder::nest(int columns, Doc inside) {
  return add({Kind::nest, "", "", {inside}, columns, false, false});
}
Doc DocBuilder::group(Doc inside, bool broken) {
  return add({Kind::group, "", "", {inside}, 0, false, broken});
}

// Whether `steps` and what follows them up to the next line break take at most `columns`. Looks at
// no more text than that, so that the whole layout takes linear time.
bool DocBuilder::fits(std::vector<Step> steps, const std::vector<Step>& rest, int columns) const {
  std::size_t rest_left = rest.size();
  while (columns >= 0) {
    if (steps.empty()) {
      if (rest_left == 0) return true;
      steps.push_back(rest[--rest_left]);
    }
    const Step step = steps.back();
    steps.pop_back();
    const Node& node = nodes_[step.doc];
    switch (node.kind) {
      case Kind::text:
        if (const std::size_t end = node.text.find('\n'); end != std::string::npos) {
          return columns_of(std::string_view(node.text).substr(0, end)) <= columns;
        }
        columns -= columns_of(node.text);
        break;
      case Kind::note:
      case Kind::hard:
        return true;
      case Kind::line:
        if (!step.flat) return columns_of(node.broken) <= columns;
        columns -= columns_of(node.text);
        break;
      case Kind::concat:
      case Kind::nest:
      case Kind::group:
        for (auto part = node.parts.rbegin(); part != node.parts.rend(); ++part) {
          const bool breaks = node.kind == Kind::group && node.must_break;
          steps.push_back({*part, step.indentation, step.flat && !breaks});
        }
        break;
    }
  }
  return false;
}

std::string DocBuilder::layout(Doc doc, int width) const {
  std::string out;
  int column = 0;
  std::vector<Step> steps = {{doc, 0, false}};
  // The indentation is written with the first text of a line, so that blank lines stay empty.
  int pending_indentation = 0;
  const auto break_line = [&](int indentation) {
    while (out.ends_with(' '))
      out.pop_back();
    out += '\n';
    column = indentation;
    pending_indentation = indentation;
  };
  const auto write = [&](const std::string& text) {
    if (text.empty()) return;
    out.append(static_cast<std::size_t>(std::exchange(pending_indentation, 0)), ' ');
    out += text;
    const std::size_t last = text.rfind('\n');
    if (last != std::string::npos) column = 0;
    column += columns_of(std::string_view(text).substr(last + 1));  // npos + 1 is 0
  };
  while (!steps.empty()) {
    const Step step = steps.back();
    steps.pop_back();
    const Node& node = nodes_[step.doc];
    switch (node.kind) {
      case Kind::text:
      case Kind::note:
        write(node.text);
        break;
      case Kind::line:
        write(step.flat ? node.text : node.broken);
        if (!step.flat) break_line(step.indentation);
        break;
      case Kind::hard:
        break_line(step.indentation);
        if (node.blank) break_line(step.indentation);
        break;
      case Kind::concat:
      case Kind::nest:
        for (auto part = node.parts.rbegin(); part != node.parts.rend(); ++part) {
          steps.push_back({*part, step.indentation + node.columns, step.flat});
        }
        break;
      case Kind::group: {
        const Step flat{node.parts[0], step.indentation, true};
        const bool is_flat = step.flat || (!node.must_break && fits({flat}, steps, width - column));
        steps.push_back({node.parts[0], step.indentation, is_flat});
        break;
      }
    }
  }
  return out;
}

}  // namespace alhazen::parser
