// Compiled once per instruction-set level: see cmake/IsostretchKernels.cmake for what may be included here.
#include "front_table.hpp"

#include <isostretch/core/isa_level.hpp>
#include <isostretch/core/pack.hpp>

namespace isostretch::cholesky {
namespace ISOSTRETCH_KERNELS {
namespace {

// A tile of tile_packs vectors and tile_columns columns stays in registers: 24 of 32 with AVX-512, else 12
// of 16.
constexpr int tile_packs = 3, tile_columns = lanes == 8 ? 8 : 4, tile_rows = tile_packs * lanes;

// The lanes of a vector by number.
ISOSTRETCH_INLINE Pack numbers() {
  alignas(64) double number[lanes];
  for (int i = 0; i < lanes; ++i) number[i] = i;
  return load<Pack>(number);
}

template <int Packs, int Columns>
struct Tile {
  Pack x[Columns][Packs];

  // The sum of products of rows of `a` with rows of `b` over k columns.
  ISOSTRETCH_INLINE void multiply(int k, const double* a, const double* b, std::size_t leading) {
    for (int j = 0; j < Columns; ++j)
      for (int p = 0; p < Packs; ++p) x[j][p] = Pack(0.0);
    for (int i = 0; i < k; ++i, a += leading, b += leading) {
      Pack row[Packs];
      for (int p = 0; p < Packs; ++p) row[p] = load<Pack>(a + p * lanes);
      for (int j = 0; j < Columns; ++j) {
        const Pack factor(b[j]);
        for (int p = 0; p < Packs; ++p) x[j][p] = fma(row[p], factor, x[j][p]);
      }
    }
  }

  // c - x
  ISOSTRETCH_INLINE void subtract_from(const double* c, std::size_t leading) {
    for (int j = 0; j < Columns; ++j)
      for (int p = 0; p < Packs; ++p)
        x[j][p] = load<Pack>(c + static_cast<std::size_t>(j) * leading + p * lanes) - x[j][p];
  }

  ISOSTRETCH_INLINE void negate() {
    for (int j = 0; j < Columns; ++j)
      for (int p = 0; p < Packs; ++p) x[j][p] = -x[j][p];
  }

  // x L^-T with the lower triangle of L at l.
  ISOSTRETCH_INLINE void divide(const double* l, std::size_t leading, const double* inverse) {
    for (int j = 0; j < Columns; ++j) {
      for (int i = 0; i < j; ++i) {
        const Pack factor(l[static_cast<std::size_t>(i) * leading + static_cast<std::size_t>(j)]);
        for (int p = 0; p < Packs; ++p) x[j][p] = x[j][p] - x[i][p] * factor;
      }
      for (int p = 0; p < Packs; ++p) x[j][p] *= Pack(inverse[j]);
    }
  }

  ISOSTRETCH_INLINE void write(double* c, std::size_t leading) const {
    for (int j = 0; j < Columns; ++j)
      for (int p = 0; p < Packs; ++p) store(c + static_cast<std::size_t>(j) * leading + p * lanes, x[j][p]);
  }

  // The first `rows` rows; those after them stay as they are.
  ISOSTRETCH_INLINE void write(double* c, std::size_t leading, int rows) const {
    for (int p = 0; p < Packs; ++p) {
      const auto inside = numbers() < Pack(static_cast<double>(rows - p * lanes));
      for (int j = 0; j < Columns; ++j) {
        double* to = c + static_cast<std::size_t>(j) * leading + p * lanes;
        store(to, select(inside, x[j][p], load<Pack>(to)));
      }
    }
  }
};

// Calls visit.template operator()<Packs>(row) for tiles that cover rows begin ... end - 1.
template <class Visit>
ISOSTRETCH_INLINE void for_tiles(int begin, int end, const Visit& visit) {
  int row = begin;
  for (; row + 2 * lanes < end; row += tile_rows) visit.template operator()<3>(row);
  for (; row + lanes < end; row += 2 * lanes) visit.template operator()<2>(row);
  for (; row < end; row += lanes) visit.template operator()<1>(row);
}

// Calls visit.template operator()<Columns>() for a number of columns that is known when the program runs.
template <int Most, class Visit>
ISOSTRETCH_INLINE void with_columns(int columns, const Visit& visit) {
  if constexpr (Most == 1) {
    visit.template operator()<1>();
  } else {
    if (columns == Most)
      visit.template operator()<Most>();
    else
      with_columns<Most - 1>(columns, visit);
  }
}

ISOSTRETCH_INLINE std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

int diagonal(const Front& block, int first, int count, double* inverse) {
  constexpr int most = 8;
  const std::size_t leading = block.leading;
  const double* row = block.values + at(first);
  double* c = block.values + at(first) * leading + at(first);
  double triangle[most * (most + lanes)];
  constexpr std::size_t width = most + lanes;
  with_columns<tile_columns>(count, [&]<int Columns>() {
    for_tiles(0, count, [&]<int Packs>(int i) {
      Tile<Packs, Columns> tile;
      tile.multiply(first, row + i, row, leading);
      tile.subtract_from(c + i, leading);
      tile.write(triangle + i, width);
    });
  });
  for (int j = 0; j < count; ++j) {
    double* column = triangle + at(j) * width;
    for (int i = 0; i < j; ++i) {
      const double factor = triangle[at(i) * width + at(j)];
      for (int r = j; r < count; ++r) column[r] -= triangle[at(i) * width + at(r)] * factor;
    }
    if (!(column[j] > 0 && column[j] < __builtin_inf())) {
      inverse[j] = column[j];
      return j;
    }
    const double root = __builtin_sqrt(column[j]);
    inverse[j] = 1 / root;
    column[j] = root;
    for (int r = j + 1; r < count; ++r) column[r] *= inverse[j];
    for (int r = j; r < count; ++r) c[at(j) * leading + at(r)] = column[r];
  }
  return count;
}

void below(const Front& block, int first, int count, const double* inverse, int begin, int end) {
  const std::size_t leading = block.leading;
  const double* a = block.values;
  double* c = block.values + at(first) * leading;
  with_columns<tile_columns>(count, [&]<int Columns>() {
    for_tiles(begin, end, [&]<int Packs>(int row) {
      Tile<Packs, Columns> tile;
      tile.multiply(first, a + row, a + first, leading);
      tile.subtract_from(c + row, leading);
      tile.divide(c + first, leading, inverse);
      if (row + Packs * lanes <= end)
        tile.write(c + row, leading);
      else
        tile.write(c + row, leading, end - row);
    });
  });
}

void update(const double* a, std::size_t leading, int k, double* c, std::size_t c_leading, int columns,
            int begin, int end, bool add) {
  for (int j = 0; j < columns && j < end; j += tile_columns) {
    const int count = columns - j < tile_columns ? columns - j : tile_columns;
    double* to = c + at(j) * c_leading;
    with_columns<tile_columns>(count, [&]<int Columns>() {
      // From a whole number of vectors on: what ends before the chunk does would write into the next one.
      // What stands above the diagonal is nobody's.
      for_tiles(j > begin ? begin + (j - begin) / lanes * lanes : begin, end, [&]<int Packs>(int row) {
        Tile<Packs, Columns> tile;
        tile.multiply(k, a + row, a + j, leading);
        if (add)
          tile.subtract_from(to + row, c_leading);
        else
          tile.negate();
        tile.write(to + row, c_leading);
      });
    });
  }
}

ISOSTRETCH_INLINE double* column_of(const Front& front, int column) {
  return front.values + column_place(static_cast<std::int64_t>(front.leading), column);
}

// What a vector covers beyond a run is written as it was: there is padding below every column.
void add(const Front& from, const Run* run, int runs, int begin, int end, const Front& to, int first) {
  const Pack number = numbers();
  const auto add_rows = [&](const double* source, double* target, int count) {
    int i = 0;
    for (; i + lanes <= count; i += lanes) store(target + i, load<Pack>(target + i) + load<Pack>(source + i));
    if (i == count) return;
    const Pack old = load<Pack>(target + i);
    store(target + i,
          select(number < Pack(static_cast<double>(count - i)), old + load<Pack>(source + i), old));
  };
  int own = 0;  // run of column j
  for (int j = begin; j < end; ++j) {
    while (run[own].row + run[own].length <= j) ++own;
    const double* source = column_of(from, j);
    const int beyond = j - run[own].row, place = run[own].place + beyond - first;
    double* target = column_of(to, place);
    add_rows(source + j, target + place, run[own].length - beyond);
    for (int r = own + 1; r < runs; ++r)
      add_rows(source + run[r].row, target + (run[r].place - first), run[r].length);
  }
}

// Columns of L that are read together, so that t is read once for all of them.
constexpr int together = 4;

template <int Columns>
ISOSTRETCH_INLINE void subtract_columns(const double* l, std::size_t leading, const double* factor, double* t,
                                        int begin, int end) {
  for (int i = begin; i < end; i += lanes) {
    Pack sum = load<Pack>(t + i);
    for (int j = 0; j < Columns; ++j) sum = sum - load<Pack>(l + at(j) * leading + i) * Pack(factor[j]);
    store(t + i, sum);
  }
}

void forward(const Front& block, double* t) {
  for (int first = 0; first < block.columns; first += together) {
    const int count = block.columns - first < together ? block.columns - first : together;
    const double* l = block.values + at(first) * block.leading;
    for (int j = 0; j < count; ++j) {
      double value = t[first + j];
      for (int i = 0; i < j; ++i) value -= l[at(i) * block.leading + at(first + j)] * t[first + i];
      t[first + j] = value / l[at(j) * block.leading + at(first + j)];
    }
    with_columns<together>(count, [&]<int Columns>() {
      subtract_columns<Columns>(l, block.leading, t + first, t, first + count, block.rows);
    });
  }
}

template <int Columns>
ISOSTRETCH_INLINE void add_products(const double* l, std::size_t leading, const double* t, int begin, int end,
                                    double* sum) {
  Pack total[Columns];
  for (int j = 0; j < Columns; ++j) total[j] = Pack(0.0);
  int i = begin;
  for (; i + lanes <= end; i += lanes) {
    const Pack value = load<Pack>(t + i);
    for (int j = 0; j < Columns; ++j) total[j] = fma(load<Pack>(l + at(j) * leading + i), value, total[j]);
  }
  for (int j = 0; j < Columns; ++j) {
    double part[lanes];
    store(part, total[j]);
    double all = 0;
    for (int lane = 0; lane < lanes; ++lane) all += part[lane];
    for (int r = i; r < end; ++r) all += l[at(j) * leading + at(r)] * t[r];
    sum[j] = all;
  }
}

void backward(const Front& block, double* t) {
  for (int first = (block.columns - 1) / together * together; first >= 0; first -= together) {
    const int count = block.columns - first < together ? block.columns - first : together;
    const double* l = block.values + at(first) * block.leading;
    double sum[together];
    with_columns<together>(count, [&]<int Columns>() {
      add_products<Columns>(l, block.leading, t, first + count, block.rows, sum);
    });
    for (int j = count - 1; j >= 0; --j) {
      double value = t[first + j] - sum[j];
      for (int i = j + 1; i < count; ++i) value -= l[at(j) * block.leading + at(first + i)] * t[first + i];
      t[first + j] = value / l[at(j) * block.leading + at(first + j)];
    }
  }
}

constexpr int wide_packs = wide / lanes;

// One row of the right-hand sides.
struct WideRow {
  Pack x[wide_packs];

  ISOSTRETCH_INLINE explicit WideRow(const double* t) {
    for (int p = 0; p < wide_packs; ++p) x[p] = load<Pack>(t + p * lanes);
  }
  ISOSTRETCH_INLINE void subtract(double factor, const double* t) {
    for (int p = 0; p < wide_packs; ++p) x[p] = x[p] - Pack(factor) * load<Pack>(t + p * lanes);
  }
  ISOSTRETCH_INLINE void write(double* t) const {
    for (int p = 0; p < wide_packs; ++p) store(t + p * lanes, x[p]);
  }
  ISOSTRETCH_INLINE void divide(double by) {
    for (int p = 0; p < wide_packs; ++p) x[p] = x[p] / Pack(by);
  }
};

void forward_wide(const Front& block, double* t) {
  for (int first = 0; first < block.columns; first += together) {
    const int count = block.columns - first < together ? block.columns - first : together;
    const double* l = block.values + at(first) * block.leading;
    for (int j = first; j < block.rows; ++j) {
      WideRow row(t + at(j) * wide);
      for (int i = 0; i < count && first + i < j; ++i)
        row.subtract(l[at(i) * block.leading + at(j)], t + at(first + i) * wide);
      if (j < first + count) row.divide(l[at(j - first) * block.leading + at(j)]);
      row.write(t + at(j) * wide);
    }
  }
}

void backward_wide(const Front& block, double* t) {
  for (int j = block.columns - 1; j >= 0; --j) {
    const double* l = block.values + at(j) * block.leading;
    WideRow row(t + at(j) * wide);
    for (int i = j + 1; i < block.rows; ++i) row.subtract(l[i], t + at(i) * wide);
    row.divide(l[j]);
    row.write(t + at(j) * wide);
  }
}

}  // namespace

extern const FrontTable table;
const FrontTable table = {tile_columns, diagonal, below,        update,       add,
                          forward,      backward, forward_wide, backward_wide};

}  // namespace ISOSTRETCH_KERNELS
}  // namespace isostretch::cholesky
