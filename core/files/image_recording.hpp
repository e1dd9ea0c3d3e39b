#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/files/csv.hpp"
#include "core/sonar_image.hpp"

/// The sonar images of a recording directory: `images.csv`, a row an image with its time, file, ranges, scale
/// and mount; `bearings.csv`, the tables of beams that the images refer to; `images/NNNNNN.pgm`, 16 bit, a
/// row a beam from port and a column a range bin from the sonar. An image's intensity is intensity_scale x
/// (pixel - zero_level). vehicle.csv, truth.csv and sonar.yaml beside them are those of every recording.
/// docs/formats.md has the columns.
namespace lookout::core {

/// Whether the directory holds an image recording: an images.csv.
bool holds_images(const std::string& directory);

/// Removes the images of a recording from the directory: images.csv, bearings.csv and the files that
/// `ImageWriter` names; anything else stays.
void remove_images(const std::string& directory);

/// The images of a recording, read one at a time: many do not fit memory together.
class ImageReader {
 public:
  /// Reads and checks the tables. Images of a sensor are later one than the other within each clock.
  /// @throws InputError naming file, line and column.
  explicit ImageReader(const std::string& directory);

  std::size_t size() const {
    return entries_.size();
  }  ///< Images, in the order of the file, by clock and time.
  std::int64_t utime(std::size_t i) const { return entries_.at(i).header.utime; }  ///< Of image i [us].
  int clock(std::size_t i) const { return entries_.at(i).clock; }  ///< Number of its clock; rises with i.

  /// Image i < size(), whole. @throws InputError naming the file: not readable, damaged, of another size.
  SonarImage read(std::size_t i) const;

 private:
  struct Entry {
    SonarImage header;      ///< All but bearings and intensities.
    std::size_t table = 0;  ///< Its index in tables_.
    std::string file;       ///< Whole path.
    double zero_level = 0.0;
    int clock = 0;
  };
  void read_tables(const std::string& path);
  void read_entries(const std::string& path);
  Entry entry_of(const CsvTable& table, std::size_t row) const;
  void require_order(const CsvTable& table, std::size_t row) const;

  std::string directory_;
  std::map<std::int64_t, std::size_t> table_index_;  ///< By the number in the file.
  std::vector<std::vector<double>> tables_;
  std::vector<Entry> entries_;
};

/// Writes the images of a recording as they come. images.csv takes its name when `close` succeeds, so that a
/// directory without it holds no recording.
class ImageWriter {
 public:
  /// Makes the directory and removes the images of another recording from it. @throws InputError where it
  /// cannot.
  explicit ImageWriter(const std::string& directory);

  /// Writes one image: to the bit where its intensities are whole multiples of `intensity_scale` within 16
  /// bits, else to half a step of 65535 between its least and largest.
  /// @param clock of its time, never below the one before.
  /// @throws std::length_error where its sizes disagree; InputError where the disk refuses.
  void add(const SonarImage& image, int clock = 0);

  std::size_t size() const { return count_; }  ///< Images written.
  void close();  ///< Writes bearings.csv and gives images.csv its name. @throws InputError.

 private:
  std::string directory_;
  CsvWriter csv_;
  std::map<std::vector<double>, std::size_t> tables_;  ///< Number of each table of beams.
  std::size_t count_ = 0;
};

}  // namespace lookout::core
