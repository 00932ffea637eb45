// ESRI ASCII grids.
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "simcore/base/text.h"
#include "simcore/io/terrain_file.h"

namespace simcore::io {
namespace {

constexpr double kUsualNoData = -9999.0;
/// A longer word is no number.
constexpr std::size_t kLongestWord = 64;

/// Words of a stream and the line they are in.
class Words {
  public:
    explicit Words(std::istream& text) : text_(text) {}

    /// The next word; empty at the end, cut off when it is too long.
    std::string next() {
        std::string word;
        int c = text_.get();
        for (; c != EOF && std::isspace(c) != 0; c = text_.get()) {
            line_ += c == '\n' ? 1 : 0;
        }
        for (; c != EOF && std::isspace(c) == 0 && word.size() < kLongestWord; c = text_.get()) {
            word += static_cast<char>(c);
        }
        if (c != EOF) {
            text_.unget();
        }
        return word;
    }

    int line() const { return line_; }

  private:
    std::istream& text_;
    int line_ = 1;
};

std::optional<double> numberIn(const std::string& word) {
    double value = 0.0;
    const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
    const char* end = word.data() + word.size();
    const auto result = std::from_chars(begin, end, value);
    return result.ec == std::errc() && result.ptr == end ? std::optional(value) : std::nullopt;
}

std::string lowerCase(std::string word) {
    for (char& c : word) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return word;
}

struct Header {
    std::optional<double> columns, rows, cell, noData;
    std::optional<double> xCorner, yCorner, xCenter, yCenter;

    std::optional<double>* find(const std::string& key) {
        return key == "ncols"                             ? &columns
               : key == "nrows"                           ? &rows
               : key == "cellsize"                        ? &cell
               : key == "nodata_value" || key == "nodata" ? &noData
               : key == "xllcorner"                       ? &xCorner
               : key == "yllcorner"                       ? &yCorner
               : key == "xllcenter" || key == "xllcentre" ? &xCenter
               : key == "yllcenter" || key == "yllcentre" ? &yCenter
                                                          : nullptr;
    }
};

bool isCount(const std::optional<double>& number) {
    return number && *number >= 2.0 && *number <= 1e6 && *number == std::floor(*number);
}

}  // namespace

Result<terrain::Raster> readAsciiGrid(std::istream& text, const std::string& name) {
    Words words(text);
    const auto problem = [&](std::string reason, std::string remedy) {
        return Problem{Severity::Critical, Text::of("{}: line {}", name, words.line()),
                       std::move(reason), std::move(remedy)};
    };
    Header header;
    std::string word = words.next();
    while (auto* field = header.find(lowerCase(word))) {
        *field = numberIn(words.next());
        if (!*field || !std::isfinite(**field)) {
            return problem(Text::of("'{}' is not followed by a number.", word),
                           Text::of("Correct the header."));
        }
        word = words.next();
    }
    if (!isCount(header.columns) || !isCount(header.rows) || !header.cell ||
        !(*header.cell > 0.0)) {
        return problem(Text::of("the header lacks ncols, nrows (2 or more) or cellsize (above 0)."),
                       Text::of("An ASCII grid begins with lines such as 'ncols 200'."));
    }
    if (*header.columns * *header.rows > static_cast<double>(terrain::kMostRasterPoints)) {
        return problem(Text::of("{:.0f} x {:.0f} points are more than {}.", *header.columns,
                                *header.rows, terrain::kMostRasterPoints),
                       Text::of("Cut out the part that is driven on, or resample it."));
    }
    terrain::Raster raster;
    raster.columns = static_cast<int>(*header.columns);
    raster.rows = static_cast<int>(*header.rows);
    raster.cell = *header.cell;
    // The corner of a cell lies half a cell before its centre, where the height holds.
    raster.x0 = header.xCenter ? *header.xCenter
                               : header.xCorner.value_or(-0.5 * raster.cell) + 0.5 * raster.cell;
    raster.y0 = header.yCenter ? *header.yCenter
                               : header.yCorner.value_or(-0.5 * raster.cell) + 0.5 * raster.cell;
    const double noData = header.noData.value_or(kUsualNoData);
    const std::size_t count =
        static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows);
    // Grows with what is there: a header alone asks for nothing.
    for (; raster.values.size() < count; word = words.next()) {
        const auto value = numberIn(word);
        if (word.empty() || !value) {
            return problem(word.empty() ? Text::of("the file ends after {} of {} heights.",
                                                   raster.values.size(), count)
                                        : Text::of("'{}' is not a number.", word),
                           Text::of("Correct the file; it may have been cut off."));
        }
        const bool none = *value == noData || !std::isfinite(*value);
        raster.values.push_back(none ? std::numeric_limits<double>::quiet_NaN() : *value);
    }
    if (!word.empty()) {
        return problem(Text::of("there is more than the {} heights of {} x {} points.", count,
                                raster.columns, raster.rows),
                       Text::of("Correct ncols or nrows."));
    }
    return raster;
}

}  // namespace simcore::io
