// parser/ast: what the author wrote, as a tree. Nothing is evaluated and nothing is lost: every
// node knows its span, names know theirs, and comments hang on the items they belong to.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/diag/source.h"

namespace alhazen::ast {

struct Expr;
struct Item;
using ExprPtr = std::unique_ptr<Expr>;  // never null in a finished tree unless a field says so
using ItemPtr = std::unique_ptr<Item>;

struct Name {
  std::string text;
  SourceSpan span;
};

// `text` with its delimiters: "// like this" or "/* so */".
struct Comment {
  std::string text;
  SourceSpan span;
  bool blank_line_before = false;
};

// "{" items "}". `dangling` are the comments after the last item.
struct Body {
  SourceSpan span;
  std::vector<ItemPtr> items;
  std::vector<Comment> dangling;
};

// ---- expressions ------------------------------------------------------------------------------

struct NumberLiteral {
  double value;
};
enum class AngleUnit { deg, rad };
struct AngleLiteral {
  double value;  // in `unit`, as written
  AngleUnit unit;
};
struct StringLiteral {
  std::string value;  // escapes resolved
};
struct HexColor {
  int red, green, blue;  // 0 to 255, sRGB
};
struct BoolLiteral {
  bool value;
};
struct NameRef {
  std::string name;
};
struct VectorLiteral {
  std::vector<ExprPtr> components;  // two or three
};
struct ListLiteral {
  std::vector<ExprPtr> elements;
};
struct Parenthesized {
  ExprPtr inner;
};

enum class UnaryOperator { negate, logical_not };
struct Unary {
  UnaryOperator op;
  SourceSpan op_span;
  ExprPtr operand;
};

enum class BinaryOperator {
  add,
  subtract,
  multiply,
  divide,
  remainder,
  power,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  logical_and,
  logical_or,
};
struct Binary {
  BinaryOperator op;
  SourceSpan op_span;
  ExprPtr left, right;
};

struct Range {
  ExprPtr first, last;
  bool inclusive;  // ..= rather than ..
  ExprPtr step;    // null without `by`
};
struct Conditional {
  ExprPtr condition, then_value, else_value;
};
struct Member {
  ExprPtr object;
  Name member;
};
struct Index {
  ExprPtr object, index;
};
struct Argument {
  std::optional<Name> name;
  ExprPtr value;
};
struct Call {
  ExprPtr callee;
  std::vector<Argument> arguments;
  SourceSpan arguments_span;  // with the parentheses
};
// `head { ... }`: head is a NameRef or a Call. Whether it makes a new glass or varies a value of
// that name is for eval to say.
struct Block {
  ExprPtr head;
  Body body;
};
// Stands where something could not be parsed; the diagnostic has been reported.
struct ErrorExpr {};

struct Expr {
  SourceSpan span;
  std::variant<NumberLiteral, AngleLiteral, StringLiteral, HexColor, BoolLiteral, NameRef,
               VectorLiteral, ListLiteral, Parenthesized, Unary, Binary, Range, Conditional, Member,
               Index, Call, Block, ErrorExpr>
      node;
  int height = 1;  // levels of the tree from here down; ParseLimits bounds it
};

// ---- items ------------------------------------------------------------------------------------

struct Let {
  Name name;
  ExprPtr value;
};
struct Param {
  Name name;
  ExprPtr value;
  ExprPtr range;  // null without `in`
  std::optional<Expr> text;
};
struct Parameter {
  Name name;
  ExprPtr default_value;  // null if there is none
};
struct Function {
  Name name;
  std::vector<Parameter> parameters;
  std::variant<ExprPtr, Body> body;  // `= expression`, or items that place shapes or return a value
};
struct For {
  Name variable;
  ExprPtr sequence;
  Body body;
};
struct If {
  ExprPtr condition;
  Body then_body;
  std::variant<std::monostate, ItemPtr, Body> else_branch;  // the item is an If
};
struct Include {
  std::string path;
  SourceSpan path_span;
};
struct Assert {
  ExprPtr condition;
  ExprPtr message;  // null if there is none
};
struct Print {
  std::vector<ExprPtr> values;
};
struct Return {
  ExprPtr value;
};
// `radius 2`, `material glass { ... }`, `sphere { ... }`, `camera perspective { ... }`.
struct Property {
  Name name;
  std::variant<ExprPtr, Body> value;
};
// `tower(3)`, `tower(3) { translate x }` where an item stands: the object, a Call or a Block whose
// head is a Call, takes its place in the scene.
struct Placement {
  ExprPtr object;
};
struct ErrorItem {};

struct Item {
  SourceSpan span;
  std::vector<Comment> leading;    // on the lines before
  std::vector<Comment> interior;   // between its tokens, outside of its bodies
  std::vector<Comment> trailing;   // on the same line, after
  bool blank_line_before = false;  // one blank line of the author's is kept by the formatter
  std::variant<Let, Param, Function, For, If, Include, Assert, Print, Return, Placement, Property,
               ErrorItem>
      node;
};

struct File {
  FileId id = kNoFile;
  int version = 1;
  SourceSpan header;
  std::vector<Comment> header_trailing;  // on the header's line
  std::vector<ItemPtr> items;
  std::vector<Comment> dangling;  // after the last item
};

}  // namespace alhazen::ast
