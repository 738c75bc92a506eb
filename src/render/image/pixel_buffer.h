// render/image: pictures in memory: a rectangle of the pixel plane and planes of named channels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace alhazen::render {

// Pixels x .. x+width-1 and y .. y+height-1; y grows downwards.
struct PixelWindow {
  int x{}, y{}, width{}, height{};
  friend bool operator==(const PixelWindow&, const PixelWindow&) = default;
};

// Planes of width * height samples, row by row from the top, one for each named channel.
template <class Sample>
class PixelBuffer {
 public:
  PixelBuffer() = default;
  // Every sample is zero. Preconditions: width and height are positive, names differ.
  PixelBuffer(int width, int height, std::vector<std::string> names)
      : width_(width), height_(height), names_(std::move(names)) {
    samples_.resize(pixel_count() * names_.size());
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return samples_.empty(); }
  std::size_t pixel_count() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }
  std::size_t channel_count() const { return names_.size(); }
  const std::vector<std::string>& names() const { return names_; }

  std::span<Sample> channel(std::size_t index) {
    return std::span(samples_).subspan(index * pixel_count(), pixel_count());
  }
  std::span<const Sample> channel(std::size_t index) const {
    return std::span(samples_).subspan(index * pixel_count(), pixel_count());
  }
  std::optional<std::size_t> find(std::string_view name) const {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (names_[i] == name) return i;
    }
    return std::nullopt;
  }

  // Columns and rows of the buffer itself, whatever window of a picture it holds.
  Sample& at(std::size_t channel_index, int column, int row) {
    return samples_[offset(channel_index, column, row)];
  }
  const Sample& at(std::size_t channel_index, int column, int row) const {
    return samples_[offset(channel_index, column, row)];
  }

  friend bool operator==(const PixelBuffer&, const PixelBuffer&) = default;

 private:
  std::size_t offset(std::size_t channel_index, int column, int row) const {
    return channel_index * pixel_count() +
           static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<std::string> names_;
  std::vector<Sample> samples_;
};

using FloatBuffer = PixelBuffer<float>;
using IdBuffer = PixelBuffer<std::uint32_t>;

}  // namespace alhazen::render
