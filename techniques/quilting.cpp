#include "techniques/quilting.h"

#include "techniques/random.h"

#include <algorithm>
#include <cmath>

namespace ffgpu::techniques {
namespace {

struct Place {
    int x = 0, y = 0;
};

// One piece on its way into the result: where it goes, and which of its sides overlap.
struct Piece {
    Place to;
    bool left, below;
};

class Quilter {
public:
    Quilter(const Field& source, const Quilt& quilt, std::uint64_t seed)
        : source_(source)
        , quilt_(quilt)
        , random_(seed)
        , result_(side(quilt), side(quilt)) {}

    Field work() {
        const int step = quilt_.block - quilt_.overlap;
        for (int row = 0; row < quilt_.across; ++row) {
            for (int column = 0; column < quilt_.across; ++column) {
                const Piece piece{{column * step, row * step}, column > 0, row > 0};
                lay(piece, choose(piece));
            }
        }
        return result_;
    }

private:
    static int side(const Quilt& quilt) {
        return quilt.across * (quilt.block - quilt.overlap) + quilt.overlap;
    }

    Place draw_place() {
        const int x = random_.below(source_.width - quilt_.block + 1);
        return {x, random_.below(source_.height - quilt_.block + 1)};
    }

    double error(const Piece& piece, Place from, int x, int y) const {
        const double difference =
            result_.at(piece.to.x + x, piece.to.y + y) - source_.at(from.x + x, from.y + y);
        return difference * difference;
    }

    double overlap_error(const Piece& piece, Place from) const {
        double sum = 0;
        for (int y = 0; y < quilt_.block; ++y) {
            for (int x = 0; x < quilt_.block; ++x) {
                const bool overlaps =
                    (piece.left && x < quilt_.overlap) || (piece.below && y < quilt_.overlap);
                if (overlaps) sum += error(piece, from, x, y);
            }
        }
        return sum;
    }

    Place choose(const Piece& piece) {
        Place best = draw_place();
        if (!piece.left && !piece.below) return best;
        double least = overlap_error(piece, best);
        for (int i = 1; i < quilt_.candidates; ++i) {
            const Place place = draw_place();
            const double sum = overlap_error(piece, place);
            if (sum >= least) continue;
            least = sum;
            best = place;
        }
        return best;
    }

    // Where the piece begins in each of its rows (across = true) or columns.
    std::vector<int> cut(const Piece& piece, Place from, bool across) const {
        Field errors(quilt_.overlap, quilt_.block);
        for (int along = 0; along < quilt_.block; ++along) {
            for (int i = 0; i < quilt_.overlap; ++i)
                errors.at(i, along) =
                    across ? error(piece, from, i, along) : error(piece, from, along, i);
        }
        return minimum_error_cut(errors);
    }

    void lay(const Piece& piece, Place from) {
        const std::vector<int> whole(static_cast<std::size_t>(quilt_.block), 0);
        const std::vector<int> left = piece.left ? cut(piece, from, true) : whole;
        const std::vector<int> below = piece.below ? cut(piece, from, false) : whole;
        for (int y = 0; y < quilt_.block; ++y) {
            for (int x = 0; x < quilt_.block; ++x) {
                if (x < left[static_cast<std::size_t>(y)]) continue;
                if (y < below[static_cast<std::size_t>(x)]) continue;
                result_.at(piece.to.x + x, piece.to.y + y) = source_.at(from.x + x, from.y + y);
            }
        }
    }

    const Field& source_;
    const Quilt& quilt_;
    Random random_;
    Field result_;
};

// Of the up to three columns that a path may come from, or go to, the first with the least sum.
int least_neighbour(const Field& sums, int column, int row) {
    int best = std::max(column - 1, 0);
    for (int next = best + 1; next <= std::min(column + 1, sums.width - 1); ++next) {
        if (sums.at(next, row) < sums.at(best, row)) best = next;
    }
    return best;
}

} // namespace

std::vector<int> minimum_error_cut(const Field& error) {
    Field sums = error;
    for (int row = 1; row < error.height; ++row) {
        for (int column = 0; column < error.width; ++column)
            sums.at(column, row) += sums.at(least_neighbour(sums, column, row - 1), row - 1);
    }
    std::vector<int> path(static_cast<std::size_t>(error.height));
    int column = 0;
    for (int other = 1; other < error.width; ++other) {
        if (sums.at(other, error.height - 1) < sums.at(column, error.height - 1)) column = other;
    }
    for (int row = error.height - 1; row >= 0; --row) {
        path[static_cast<std::size_t>(row)] = column;
        if (row > 0) column = least_neighbour(sums, column, row - 1);
    }
    return path;
}

Field quilt(const Field& source, const Quilt& quilt, std::uint64_t seed) {
    return Quilter(source, quilt, seed).work();
}

} // namespace ffgpu::techniques
