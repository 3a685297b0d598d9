#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/noise.h"
#include "tests/gallery/oracles/space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ffgpu::gallery {
namespace {

using Row = std::vector<double>;
using Grid = std::vector<Row>;

constexpr int Size = 64, Steps = 2000;

std::size_t wrap(int i) {
    return static_cast<std::size_t>((i + Size) % Size);
}

// Gray and Scott's equations, with the rates that the library names as its own.
Grid react() {
    Grid u(Size, Row(Size, 1)), v(Size, Row(Size, 0));
    Draws draws(5);
    for (int drop = 0; drop < 6; ++drop) {
        const int x = static_cast<int>(draws.next() % Size);
        const int y = static_cast<int>(draws.next() % Size);
        for (int i = 0; i < 49; ++i) {
            u[wrap(y + i / 7 - 3)][wrap(x + i % 7 - 3)] = 0.5;
            v[wrap(y + i / 7 - 3)][wrap(x + i % 7 - 3)] = 0.25;
        }
    }
    const auto spread = [](const Grid& g, int x, int y) {
        const std::size_t row = wrap(y), column = wrap(x);
        return g[row][wrap(x + 1)] + g[row][wrap(x - 1)] + g[wrap(y + 1)][column] +
               g[wrap(y - 1)][column] - 4 * g[row][column];
    };
    for (int step = 0; step < Steps; ++step) {
        Grid du = u, dv = v;
        for (int y = 0; y < Size; ++y) {
            for (int x = 0; x < Size; ++x) {
                const double a = u[wrap(y)][wrap(x)], b = v[wrap(y)][wrap(x)];
                du[wrap(y)][wrap(x)] += 0.16 * spread(u, x, y) - a * b * b + 0.035 * (1 - a);
                dv[wrap(y)][wrap(x)] += 0.08 * spread(v, x, y) + a * b * b - 0.095 * b;
            }
        }
        u.swap(du);
        v.swap(dv);
    }
    return v;
}

constexpr int Block = 23, Overlap = 8, Across = 8, Candidates = 60;
constexpr int Stride = Block - Overlap, Side = Across * Stride + Overlap;

struct Piece {
    std::size_t x, y;           // where it goes
    std::size_t from_x, from_y; // where it comes from
};

double gap(const Grid& result, const Grid& source, const Piece& p, std::size_t x, std::size_t y) {
    const double difference = result[p.y + y][p.x + x] - source[p.from_y + y][p.from_x + x];
    return difference * difference;
}

// The best path over a strip: from each row to the next at most one column aside. Bellman and
// Ford's relaxation, until nothing improves.
std::vector<std::size_t> best_path(const Grid& cost) {
    const std::size_t rows = cost.size(), columns = cost[0].size();
    Grid least(rows, Row(columns, std::numeric_limits<double>::infinity()));
    least[0] = cost[0];
    for (bool improved = true; improved;) {
        improved = false;
        for (std::size_t i = 0; i < (rows - 1) * columns * 3; ++i) {
            const std::size_t row = i / 3 / columns, from = i / 3 % columns, to = from + i % 3;
            if (to == 0 || to > columns) continue;
            const double sum = least[row][from] + cost[row + 1][to - 1];
            if (sum >= least[row + 1][to - 1]) continue;
            least[row + 1][to - 1] = sum;
            improved = true;
        }
    }
    std::vector<std::size_t> path(rows);
    const Row& last = least.back();
    path.back() =
        static_cast<std::size_t>(std::min_element(last.begin(), last.end()) - last.begin());
    for (std::size_t row = rows - 1; row > 0; --row) {
        const std::size_t low = path[row] == 0 ? 0 : path[row] - 1;
        const std::size_t high = std::min(path[row] + 2, columns);
        const auto begin = least[row - 1].begin();
        path[row - 1] =
            static_cast<std::size_t>(std::min_element(begin + static_cast<std::ptrdiff_t>(low),
                                                      begin + static_cast<std::ptrdiff_t>(high)) -
                                     begin);
    }
    return path;
}

std::vector<std::size_t>
cut(const Grid& result, const Grid& source, const Piece& piece, bool upright) {
    Grid cost(Block, Row(Overlap));
    for (std::size_t i = 0; i < Block; ++i) {
        for (std::size_t j = 0; j < Overlap; ++j)
            cost[i][j] =
                upright ? gap(result, source, piece, j, i) : gap(result, source, piece, i, j);
    }
    return best_path(cost);
}

double mismatch(const Grid& result, const Grid& source, const Piece& piece) {
    double sum = 0;
    for (std::size_t y = 0; y < Block; ++y) {
        for (std::size_t x = 0; x < Block; ++x) {
            if ((piece.x > 0 && x < Overlap) || (piece.y > 0 && y < Overlap))
                sum += gap(result, source, piece, x, y);
        }
    }
    return sum;
}

Piece choose(const Grid& result, const Grid& source, Draws& draws, Piece piece) {
    Piece best = piece;
    double least = std::numeric_limits<double>::infinity();
    const bool first = piece.x == 0 && piece.y == 0;
    for (int i = 0; i < (first ? 1 : Candidates); ++i) {
        piece.from_x = draws.next() % (Size - Block + 1);
        piece.from_y = draws.next() % (Size - Block + 1);
        const double sum = mismatch(result, source, piece);
        if (sum >= least) continue;
        least = sum;
        best = piece;
    }
    return best;
}

Grid quilted(const Grid& source) {
    Grid result(Side, Row(Side, 0));
    Draws draws(3);
    for (std::size_t i = 0; i < Across * Across; ++i) {
        const Piece piece =
            choose(result, source, draws, {i % Across * Stride, i / Across * Stride, 0, 0});
        std::vector<std::size_t> left(Block, 0), below(Block, 0);
        if (piece.x > 0) left = cut(result, source, piece, true);
        if (piece.y > 0) below = cut(result, source, piece, false);
        for (std::size_t y = 0; y < Block; ++y) {
            for (std::size_t x = 0; x < Block; ++x) {
                if (x >= left[y] && y >= below[x])
                    result[piece.y + y][piece.x + x] = source[piece.from_y + y][piece.from_x + x];
            }
        }
    }
    return result;
}

double between(const Grid& grid, const glm::dvec2& uv) {
    const auto size = static_cast<double>(grid.size());
    const double x = uv.x * size - 0.5, y = uv.y * size - 0.5;
    const auto at = [&](double column, double row) {
        const auto i = static_cast<std::size_t>(std::fmod(column + size, size));
        return grid[static_cast<std::size_t>(std::fmod(row + size, size))][i];
    };
    const double fx = std::floor(x), fy = std::floor(y), s = x - fx, t = y - fy;
    return (1 - t) * ((1 - s) * at(fx, fy) + s * at(fx + 1, fy)) +
           t * ((1 - s) * at(fx, fy + 1) + s * at(fx + 1, fy + 1));
}

Oracle oracle() {
    const Grid grown = react();
    return [grown, larger = quilted(grown)](const glm::dvec2& window) {
        const Place place = place_in(window, 2, 1);
        const glm::dvec2 uv = (place.pixel - glm::dvec2(16, 56)) / 128.0;
        if (uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1) return Color(0.1);
        const double value = between(place.panel == 0 ? grown : larger, uv) / 0.4;
        return Color(std::clamp(value, 0.0, 1.0));
    };
}

} // namespace

Claim grown_textures_claim() {
    return {
        "T22",
        "du/dt = Du lap u - u v^2 + F (1 - u), dv/dt = Dv lap v + u v^2 - (F + k) v; quilting: the "
        "cut minimises sum (old - new)^2 over the overlap",
        oracle,
        0,
        2,
        0.6,
        "8 bits of texels and weights; the oracle integrates the equations itself",
        "1000 steps instead of 2000"};
}

} // namespace ffgpu::gallery
