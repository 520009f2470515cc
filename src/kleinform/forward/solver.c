/* SPDX-License-Identifier: BSD-3-Clause */
/* The eliminant's way to all assembly modes, for rows where every zero of it is simple.

   It is that of eliminant.py: the same samples, cells, checks and bounds. What needs more is
   left to NumPy: C near the plane of a leg, zero legs, zeros that lie together, doubts.
   Compiled once for each set of instructions, VARIANT; the results have the same bits. */
#include "simd.h"

#define KLEINFORM_API static inline
#define KLEINFORM_BODY INLINE
#include "kernels.c"

#include <stdlib.h>

#include "complete.h"
#include "isolate.h"
#include "solver.h"

#define EPS 2.220446049250313e-16
/* cases.py: rounding of distances, and C near the plane of a leg, in reaches. */
#define REACH_ROUNDING 8.0
#define NEAR_PLANE 1e-3
/* circle.py: C almost in the plane of a leg, in radii. */
#define NEAR_PLANE_OF_BASE 0.01
/* eliminant.py and polish.py. */
#define ROUNDING 8.0
#define LEAST_ROUNDING (64.0 * EPS)
#define EDGE 1e-7
#define SAME_MODE 1e-9
#define CLOSE 1000.0
/* joints.py: that of joint values which were rounded to float64. */
#define LEAST_TOLERANCE (4.0 * EPS)
#define FARTHEST 0.05
/* Where n_1 turns less with psi than this, zeros must be as much farther apart. */
#define SLOW 0.1
#define STEPS 6
#define CONVERGED 1e-9

/* Rows that are solved at once, so that what lies between stays in cache. */
#define CHUNK (4 * ROWS)

/* The circle of B of the base limb, the limbs relabelled so that the base is limb 1. */
enum { RADIUS, POSITION, LENGTHS = 4, FAR_COSINE = 7, FAR_SINE, STRETCH, GEOMETRY };

struct circle {
    double geometry[GEOMETRY];
    int base;
};

/* What is known of a row: still to be tried, all modes found, or left to others. */
enum state { TO_TRY, SETTLED, LEFT };

struct work {
    /* A chunk of rows, and the modes that were found in each. */
    struct row row[CHUNK];
    enum state state[CHUNK];
    int count[CHUNK];
    size_t first[CHUNK];
    size_t found_count;
    struct found found[CHUNK * MOST_ZEROS];
    struct found in_order[CHUNK * MOST_ZEROS];
    struct mode mode[CHUNK * MOST_ZEROS];
    /* Zeros nearer than this may merge within the tolerance. */
    double near;

    /* A block of them, with the circles of their base limbs. */
    struct circle circle[ROWS];
    struct isolation isolation;
    /* At the zeros: the middle of the cell and from there, n of the base limb and of the
       next, e of the base limb, and whether it is sure. */
    double at[ROWS * MOST_ZEROS];
    double directions[ROWS * MOST_ZEROS / LANES][6][LANES];
    double distance[ROWS * MOST_ZEROS];
    double sure[ROWS * MOST_ZEROS];
};

/* Rows ------------------------------------------------------------------------------------ */

static double larger(double one, double other)
{
    return one > other ? one : other;
}

/* A row of unit size: a power of two changes no digit. False if there is none. */
static int read_row(const struct given *given, size_t index, struct row *row)
{
    const double *position = given->position + 3 * index, *lengths = given->lengths + 3 * index;
    double size = fabs(given->radius[index]);
    int exponent;
    for (int k = 0; k < 3; ++k)
        size = larger(larger(size, fabs(position[k])), fabs(lengths[k]));
    if (!(size > 1e-300 && size < 1e300))
        return 0;
    frexp(size, &exponent);
    row->size = ldexp(1.0, exponent);
    row->radius = ldexp(given->radius[index], -exponent);
    for (int k = 0; k < 3; ++k) {
        row->position[k] = ldexp(position[k], -exponent);
        row->lengths[k] = ldexp(lengths[k], -exponent);
    }
    return 1;
}

/* C off the planes of the legs and their circles, and no leg of length zero. */
static int is_ordinary(const struct row *row, double tolerance)
{
    const double x = row->position[0], y = row->position[1], z = row->position[2];
    const double size = row->radius + sqrt(x * x + y * y + z * z);
    for (int limb = 0; limb < 3; ++limb) {
        const double length = row->lengths[limb], reach = size + length;
        const double across = row->radius - COSINE[limb] * x + SINE[limb] * y;
        const double slack = (REACH_ROUNDING * EPS + tolerance) * reach;
        const double foot_x = x - row->radius * COSINE[limb];
        const double foot_y = y + row->radius * SINE[limb];
        const double distance = sqrt(foot_x * foot_x + foot_y * foot_y + z * z);
        const int in_plane = fabs(across) <= NEAR_PLANE * reach;
        const int on_circle = fabs(across) <= slack && fabs(distance - length) <= slack;
        if (in_plane || on_circle || length <= REACH_ROUNDING * EPS * reach)
            return 0;
    }
    return 1;
}

/* Circles --------------------------------------------------------------------------------- */

/* The ratio that evens the circle out, and the direction of its farthest point from C. */
static double stretch_of(const struct row *row, int limb, double *far)
{
    const double x = row->position[0], y = row->position[1], z = row->position[2];
    const double across = row->radius - COSINE[limb] * x + SINE[limb] * y;
    const double aside = SINE[limb] * x + COSINE[limb] * y;
    const double offset = sqrt(aside * aside + z * z), length = row->lengths[limb];
    const double longest = across * across + (offset + length) * (offset + length);
    const double shortest = across * across + (offset - length) * (offset - length);
    far[0] = offset > 0.0 ? -aside / offset : -1.0;
    far[1] = offset > 0.0 ? -z / offset : 0.0;
    return sqrt(sqrt(longest / shortest));
}

/* The limbs in the order in which they are tried as base: that which keeps B at the most even
   distance from C first, but before it one with C almost in the plane of its leg. */
static int base_of(const struct row *row, const double *stretch, int rank)
{
    double score[3];
    int place[3] = {0, 0, 0};
    for (int limb = 0; limb < 3; ++limb) {
        const double x = row->position[0], y = row->position[1];
        const double across = row->radius - COSINE[limb] * x + SINE[limb] * y;
        const int near = fabs(across) <= NEAR_PLANE_OF_BASE * row->radius;
        score[limb] = near ? -stretch[limb] : stretch[limb];
    }
    for (int limb = 1; limb < 3; ++limb)
        for (int other = 0; other < limb; ++other)
            ++place[score[limb] < score[other] ? other : limb];
    return place[0] == rank ? 0 : (place[1] == rank ? 1 : 2);
}

static void circle_of(const struct row *row, int rank, struct circle *circle)
{
    double far[3][2], stretch[3];
    double *to = circle->geometry;
    for (int limb = 0; limb < 3; ++limb)
        stretch[limb] = stretch_of(row, limb, far[limb]);
    const int base = base_of(row, stretch, rank);
    const double x = row->position[0], y = row->position[1];
    circle->base = base;
    to[RADIUS] = row->radius;
    to[POSITION] = COSINE[base] * x - SINE[base] * y;
    to[POSITION + 1] = SINE[base] * x + COSINE[base] * y;
    to[POSITION + 2] = row->position[2];
    for (int k = 0; k < 3; ++k)
        to[LENGTHS + k] = row->lengths[(base + k) % 3];
    to[FAR_COSINE] = far[base][0];
    to[FAR_SINE] = far[base][1];
    to[STRETCH] = stretch[base];
}

/* The least that n_1 turns with psi, or less. */
static double least_turn(const double *geometry)
{
    const double across = fabs(geometry[RADIUS] - geometry[POSITION]);
    const double y = geometry[POSITION + 1], z = geometry[POSITION + 2];
    const double length = geometry[LENGTHS], farthest = sqrt(y * y + z * z) + length;
    return across * length / ((across * across + farthest * farthest) * geometry[STRETCH]);
}

/* How far clusters are halved. Complex zeros at 0.14 w from the middle of a cell of width w
   leave it without a change of sign: in wide cells folds that count do not hide. */
static int deepest_of(const double *geometry, double near)
{
    const double turn = least_turn(geometry);
    const double least = 4.0 * near * larger(1.0, SLOW / turn);
    int level = HALVINGS;
    while (level < DEEPEST && CELL / (double)(2 << level) >= least)
        ++level;
    return level;
}

/* Cosine and sine of the leg's angle, from those of half of psi. */
INLINE void leg_at(
    double x, double y, double stretch, double far_cosine, double far_sine, double *angle,
    int stride)
{
    const double along = stretch * y, square = x * x + along * along;
    const double cosine = (x * x - along * along) / square, sine = 2.0 * x * along / square;
    angle[0] = far_cosine * cosine - far_sine * sine;
    angle[stride] = far_sine * cosine + far_cosine * sine;
}

/* A vector that is not parallel to n_1: i or k. */
INLINE void reference_at(
    double radius, double c_x, double c_z, double length, double sine, double *reference,
    int stride)
{
    const int upright = fabs(radius - c_x) <= fabs(length * sine - c_z);
    reference[0] = upright ? 1.0 : 0.0;
    reference[stride] = 0.0;
    reference[2 * stride] = upright ? 0.0 : 1.0;
}

/* The weighted eliminant on the circle, and its largest size. */
static double sampled(const double (*geometry)[ROWS], int row, double *RESTRICT values)
{
    ALIGNED double angle[2][PADDED], reference[3][PADDED];
    const double radius = geometry[RADIUS][row], length = geometry[LENGTHS][row];
    const double c_x = geometry[POSITION][row], c_z = geometry[POSITION + 2][row];
    const double far_cosine = geometry[FAR_COSINE][row], far_sine = geometry[FAR_SINE][row];
    const double stretch = geometry[STRETCH][row], square = stretch * stretch;
    double largest = 0.0;
    SIMD
    for (int k = 0; k < PADDED; ++k) {
        leg_at(kleinform_tables.half_cosine[k], kleinform_tables.half_sine[k], stretch,
               far_cosine, far_sine, angle[0] + k, PADDED);
        reference_at(radius, c_x, c_z, length, angle[1][k], reference[0] + k, PADDED);
    }
    SIMD
    for (int k = 0; k < PADDED; ++k) {
        double bound;
        eliminant_body(PADDED, geometry[RADIUS] + row, geometry[POSITION] + row,
                       geometry[LENGTHS] + row, angle[0] + k, reference[0] + k, values + k,
                       &bound);
    }
    for (int k = 0; k < PADDED; ++k) {
        const double x = kleinform_tables.half_cosine[k], y = kleinform_tables.half_sine[k];
        const double x2 = x * x, y2 = y * y;
        const double even = (x2 + square * y2) * (x2 + y2 / square);
        const double fourth = (even * even) * (even * even);
        values[k] *= fourth * fourth;
    }
    for (int k = 0; k < PADDED; ++k)
        largest = larger(fabs(values[k]), largest);
    return largest;
}

/* Coefficients of the eliminant, scaled to largest sample 1, and the bound on the errors of
   its values; false if there are none. */
static int fourier(
    const double (*geometry)[ROWS], int row, double *RESTRICT sums, double *rounding)
{
    ALIGNED double values[PADDED];
    const double scale = 1.0 / sampled(geometry, row, values);
    double all = 0.0;
    for (int i = 0; i < PADDED; ++i)
        sums[i] = 0.0;
    for (int k = 0; k < SAMPLES; ++k) {
        const double value = scale * values[k];
        SIMD
        for (int i = 0; i < PADDED; ++i)
            sums[i] += value * kleinform_tables.harmonics[k][i];
    }
    for (int i = 0; i < COEFFICIENTS + SURPLUS; ++i)
        all += fabs(sums[i]);
    const double *rest = sums + COEFFICIENTS;
    const double seventeenth = sqrt(rest[0] * rest[0] + rest[1] * rest[1]);
    *rounding = ROUNDING * larger(seventeenth, fabs(rest[2])) + LEAST_ROUNDING;
    return all < HUGE_VAL;
}

/* Zeros ----------------------------------------------------------------------------------- */

/* LANES zeros on their way to modes. */
struct starts {
    double geometry[GEOMETRY][LANES];
    double low[LANES], width[LANES], place[LANES], middle[2][LANES];
    /* Half of psi, of the guess. */
    double half[2][LANES];
    double angle[2][LANES], directions[6][LANES], distance[LANES], converged[LANES];
};

static void gather(const struct work *work, size_t start, int used, struct starts *at)
{
    const struct zeros *zeros = &work->isolation.zeros;
    for (int lane = 0; lane < LANES; ++lane) {
        const size_t number = start + (size_t)(lane < used ? lane : 0);
        const double *geometry = work->circle[zeros->row[number]].geometry;
        for (int k = 0; k < GEOMETRY; ++k)
            at->geometry[k][lane] = geometry[k];
        at->low[lane] = zeros->low[number];
        at->width[lane] = zeros->width[number];
        at->middle[0][lane] = kleinform_tables.middle_cosine[zeros->cell[number]];
        at->middle[1][lane] = kleinform_tables.middle_sine[zeros->cell[number]];
    }
}

/* Angles of the base legs at the zeros, and directions, as `starts` in polish.py. */
static void start_lanes(double (*local)[LANES], struct starts *at)
{
    ALIGNED double reference[3][LANES], frame[9][LANES], powers[8][LANES], half[2][LANES];
    crossing((const double(*)[LANES])local, at->place);
    SIMD
    for (int lane = 0; lane < LANES; ++lane) {
        const double place = at->low[lane] + at->width[lane] * at->place[lane];
        /* Half of psi from the middle of the cell, at most 0.025. */
        const double d = 0.5 * CELL * (place - 0.5), d2 = d * d;
        const double cosine = 1.0 - d2 * (1.0 / 2 - d2 * (1.0 / 24 - d2 * (1.0 / 720)));
        const double sine = d * (1.0 - d2 * (1.0 / 6 - d2 * (1.0 / 120 - d2 * (1.0 / 5040))));
        const double x = at->middle[0][lane] * cosine - at->middle[1][lane] * sine;
        const double y = at->middle[1][lane] * cosine + at->middle[0][lane] * sine;
        const double *g = at->geometry[0] + lane;
        at->place[lane] = place;
        at->half[0][lane] = x;
        at->half[1][lane] = y;
        leg_at(x, y, g[STRETCH * LANES], g[FAR_COSINE * LANES], g[FAR_SINE * LANES],
               at->angle[0] + lane, LANES);
        reference_at(g[0], g[POSITION * LANES], g[(POSITION + 2) * LANES], g[LENGTHS * LANES],
                     at->angle[1][lane], reference[0] + lane, LANES);
    }
    SIMD
    for (int lane = 0; lane < LANES; ++lane)
        half_turn_body(LANES, at->geometry[RADIUS] + lane, at->geometry[POSITION] + lane,
                       at->geometry[LENGTHS] + lane, at->angle[0] + lane, reference[0] + lane,
                       frame[0] + lane, powers[0] + lane);
    SIMD
    for (int lane = 0; lane < LANES; ++lane) {
        /* Both rows of the adjugate are along (x^3, x^2 y, x y^2, y^3): the longer one. */
        double first = 0.0, second = 0.0;
        for (int k = 0; k < 4; ++k) {
            first += powers[k][lane] * powers[k][lane];
            second += powers[4 + k][lane] * powers[4 + k][lane];
        }
        half[0][lane] = first >= second ? powers[0][lane] : powers[6][lane];
        half[1][lane] = first >= second ? powers[1][lane] : powers[7][lane];
    }
    SIMD
    for (int lane = 0; lane < LANES; ++lane)
        turned_directions_body(LANES, frame[0] + lane, half[0] + lane,
                               at->directions[0] + lane);
}

/* Newton's method in the angle of the base leg and the turn about n_1. A zero that has
   converged stays as it is, whatever lies beside it. */
static void newton_lanes(struct starts *at)
{
    ALIGNED double angle[2][LANES], directions[6][LANES], distance[LANES], steps[2][LANES];
    double waiting = 1.0;
    for (int lane = 0; lane < LANES; ++lane)
        at->converged[lane] = 0.0;
    for (int step = 0; step < STEPS && waiting > 0.0; ++step) {
        SIMD
        for (int lane = 0; lane < LANES; ++lane)
            leg_step_body(LANES, at->geometry[RADIUS] + lane, at->geometry[POSITION] + lane,
                          at->geometry[LENGTHS] + lane, at->angle[0] + lane,
                          at->directions[3] + lane, angle[0] + lane, directions[0] + lane,
                          distance + lane, steps[0] + lane);
        SIMD
        for (int lane = 0; lane < LANES; ++lane) {
            const int still = at->converged[lane] > 0.0;
            const int now = (fabs(steps[0][lane]) <= CONVERGED) &
                            (fabs(steps[1][lane]) <= CONVERGED);
            for (int k = 0; k < 2; ++k)
                at->angle[k][lane] = still ? at->angle[k][lane] : angle[k][lane];
            for (int k = 0; k < 6; ++k)
                at->directions[k][lane] = still ? at->directions[k][lane] : directions[k][lane];
            at->distance[lane] = still ? at->distance[lane] : distance[lane];
            at->converged[lane] = (still | now) ? 1.0 : 0.0;
        }
        waiting = 0.0;
        for (int lane = 0; lane < LANES; ++lane)
            waiting += 1.0 - at->converged[lane];
    }
}

/* Whether the zeros converged within their cells. */
static void check_lanes(const struct starts *at, double *RESTRICT sure)
{
    SIMD
    for (int lane = 0; lane < LANES; ++lane) {
        const double far_cosine = at->geometry[FAR_COSINE][lane];
        const double far_sine = at->geometry[FAR_SINE][lane];
        const double stretch = at->geometry[STRETCH][lane];
        const double cosine = at->angle[0][lane] * far_cosine + at->angle[1][lane] * far_sine;
        const double sine = at->angle[1][lane] * far_cosine - at->angle[0][lane] * far_sine;
        /* 1 + cosine and 1 - cosine, the smaller one without cancellation. */
        const double great = 1.0 + fabs(cosine), small = sine * sine / great;
        const double near = cosine < 0.0 ? small : great, far = cosine < 0.0 ? great : small;
        /* Cosine and sine of psi times something, and of psi from the guess. */
        const double psi_x = stretch * stretch * near - far, psi_y = 2.0 * stretch * sine;
        const double x = at->half[0][lane], y = at->half[1][lane];
        const double guess_x = x * x - y * y, guess_y = 2.0 * x * y;
        const double moved = angle_of(psi_y * guess_x - psi_x * guess_y,
                                      psi_x * guess_x + psi_y * guess_y);
        const double low = CELL * (at->low[lane] - at->place[lane]);
        const double high = low + CELL * at->width[lane];
        const int inside = (moved >= low - EDGE) & (moved <= high + EDGE);
        sure[lane] = (inside & (at->converged[lane] > 0.0)) ? 1.0 : 0.0;
    }
}

/* Polish all zeros of a block. */
static void polish(struct work *work)
{
    struct zeros *zeros = &work->isolation.zeros;
    ALIGNED struct starts at;
    for (size_t start = 0; start < zeros->count; start += LANES) {
        const size_t left = zeros->count - start;
        const int used = left < LANES ? (int)left : LANES;
        double(*local)[LANES] = zeros->local[start / LANES];
        for (int lane = used; lane < LANES; ++lane)
            for (int i = 0; i <= LOCAL; ++i)
                local[i][lane] = local[i][0];
        gather(work, start, used, &at);
        start_lanes(local, &at);
        newton_lanes(&at);
        check_lanes(&at, work->sure + start);
        for (int lane = 0; lane < used; ++lane)
            work->at[start + lane] = zeros->cell[start + lane] + at.place[lane];
        memcpy(work->directions[start / LANES], at.directions, sizeof at.directions);
        memcpy(work->distance + start, at.distance, sizeof at.distance);
    }
}

/* Modes of a row -------------------------------------------------------------------------- */

/* Put the zeros of a row in the order of psi. */
static void sort_zeros(const double *at, int *zero, int count)
{
    for (int k = 1; k < count; ++k) {
        const int moved = zero[k];
        int place = k;
        for (; place > 0 && at[zero[place - 1]] > at[moved]; --place)
            zero[place] = zero[place - 1];
        zero[place] = moved;
    }
}

/* The largest difference of the directions of two zeros. */
static double apart(const struct work *work, int one, int other)
{
    double gap = 0.0;
    for (int k = 0; k < 6; ++k)
        gap = larger(gap, fabs(work->directions[one / LANES][k][one % LANES] -
                               work->directions[other / LANES][k][other % LANES]));
    return gap;
}

/* Whether zeros of a row are so near to one another that the tolerance might merge them.
   Zeros whose directions are near are neighbours, because C is off the plane of the leg. */
static int are_near(const struct work *work, const int *zero, int count)
{
    for (int k = 0; k + 1 < count; ++k)
        if ((work->at[zero[k + 1]] - work->at[zero[k]]) * CELL <= work->near)
            return 1;
    for (int k = 0; k < count; ++k)
        if (apart(work, zero[k], zero[k + 1 < count ? k + 1 : 0]) <= work->near)
            return 1;
    return 0;
}

/* Whether the zeros of a row are all its modes: sure, all different, and even in number. */
static int is_complete(const struct work *work, const int *zero, int count)
{
    for (int k = 0; k < count; ++k)
        if (work->sure[zero[k]] == 0.0 ||
            !(apart(work, zero[k], zero[k + 1 < count ? k + 1 : 0]) > SAME_MODE))
            return 0;
    return count % 2 == 0;
}

static void take_row(struct work *work, int in_block, int row)
{
    struct isolation *isolation = &work->isolation;
    const int count = isolation->count[in_block];
    int *zero = isolation->zero[in_block];
    if (isolation->failed[in_block])
        return;
    sort_zeros(work->at, zero, count);
    /* What may be a fold is one, whether or not another limb shows it: folds are for NumPy. */
    if (isolation->folded[in_block] || are_near(work, zero, count)) {
        work->state[row] = LEFT;
        return;
    }
    if (!is_complete(work, zero, count))
        return;
    work->state[row] = SETTLED;
    work->count[row] = count;
    work->first[row] = work->found_count;
    for (int k = 0; k < count; ++k) {
        struct found *found = work->found + work->found_count++;
        for (int i = 0; i < 6; ++i)
            found->directions[i] = work->directions[zero[k] / LANES][i][zero[k] % LANES];
        found->distance = work->distance[zero[k]];
        found->row = row;
        found->base = work->circle[in_block].base;
    }
}

/* Blocks and chunks ----------------------------------------------------------------------- */

/* Try one base limb for each row of a block. */
static void attempt(struct work *work, const int *rows, int count, int rank)
{
    struct isolation *isolation = &work->isolation;
    ALIGNED double geometry[GEOMETRY][ROWS];
    ALIGNED double sums[PADDED];
    double rounding;
    isolation->zeros.count = isolation->parts = 0;
    for (int k = 0; k < count; ++k) {
        circle_of(work->row + rows[k], rank, work->circle + k);
        for (int i = 0; i < GEOMETRY; ++i)
            geometry[i][k] = work->circle[k].geometry[i];
        isolation->deepest[k] = deepest_of(work->circle[k].geometry, work->near);
    }
    for (int k = 0; k < count; ++k) {
        isolation->count[k] = isolation->clusters[k] = isolation->folded[k] = 0;
        isolation->failed[k] = !fourier((const double(*)[ROWS])geometry, k, sums, &rounding);
        if (!isolation->failed[k])
            isolate_row(isolation, k, sums, rounding);
    }
    isolate_parts(isolation);
    polish(work);
    for (int k = 0; k < count; ++k)
        take_row(work, k, rows[k]);
}

static void find_modes(struct work *work, int rows)
{
    int block[ROWS];
    work->found_count = 0;
    for (int rank = 0; rank < 3; ++rank)
        for (int row = 0, count = 0; row < rows; ++row) {
            if (work->state[row] == TO_TRY)
                block[count++] = row;
            if (count && (count == ROWS || row == rows - 1)) {
                attempt(work, block, count, rank);
                count = 0;
            }
        }
}

/* Complete the modes that were found, in the order of the rows. */
static void complete_rows(struct work *work, int rows)
{
    size_t count = 0;
    for (int row = 0; row < rows; ++row) {
        if (work->state[row] != SETTLED)
            continue;
        const struct found *own = work->found + work->first[row];
        memcpy(work->in_order + count, own, (size_t)work->count[row] * sizeof *own);
        work->first[row] = count;
        count += (size_t)work->count[row];
    }
    complete(work->row, work->in_order, count, work->mode);
}

static int grow(double **numbers, size_t bytes)
{
    double *larger_one = realloc(*numbers, bytes);
    if (larger_one)
        *numbers = larger_one;
    return larger_one != NULL;
}

/* Room for some more modes. */
static int reserve(struct modes *modes, size_t more)
{
    const size_t needed = modes->count + more, room = needed + needed / 2;
    const size_t bytes = 9 * room * sizeof(double);
    if (needed <= modes->room)
        return 1;
    if (room < needed || bytes / (9 * sizeof(double)) != room)
        return 0;
    if (!grow(&modes->rotation, bytes) || !grow(&modes->directions, bytes) ||
        !grow(&modes->platform_joints, bytes) || !grow(&modes->extension, bytes / 3))
        return 0;
    modes->room = room;
    return 1;
}

static void append(struct modes *modes, const struct mode *mode)
{
    const size_t at = modes->count++;
    memcpy(modes->rotation + 9 * at, mode->rotation, sizeof mode->rotation);
    memcpy(modes->directions + 9 * at, mode->directions, sizeof mode->directions);
    memcpy(modes->platform_joints + 9 * at, mode->platform_joints,
           sizeof mode->platform_joints);
    memcpy(modes->extension + 3 * at, mode->extension, sizeof mode->extension);
}

/* Append the modes of a row in their order; false if the closure equations fail in one. */
static int append_row(struct modes *modes, const struct mode *mode, int count)
{
    int order[MOST_ZEROS];
    for (int k = 0; k < count; ++k) {
        int place = k;
        if (mode[k].holds == 0.0)
            return 0;
        for (; place > 0 && before(mode + k, mode + order[place - 1]); --place)
            order[place] = order[place - 1];
        order[place] = k;
    }
    for (int k = 0; k < count; ++k)
        append(modes, mode + order[k]);
    return 1;
}

static int solve_chunk(
    struct work *work, const struct given *given, size_t start, int rows, int64_t *count,
    struct modes *modes)
{
    size_t most = 0;
    for (int row = 0; row < rows; ++row) {
        const int read = read_row(given, start + row, work->row + row);
        const int ordinary = read && is_ordinary(work->row + row, given->tolerance);
        work->state[row] = ordinary ? TO_TRY : LEFT;
    }
    find_modes(work, rows);
    complete_rows(work, rows);
    for (int row = 0; row < rows; ++row)
        most += work->state[row] == SETTLED ? (size_t)work->count[row] : 0;
    if (!reserve(modes, most))
        return 0;
    for (int row = 0; row < rows; ++row) {
        const int settled = work->state[row] == SETTLED &&
                            append_row(modes, work->mode + work->first[row], work->count[row]);
        count[row] = settled ? work->count[row] : -1;
    }
    return 1;
}

int VARIANT_OF(kleinform_solver)(
    const struct given *given, int64_t *count, struct modes *modes)
{
    struct work *work = malloc(sizeof *work);
    const double near = CLOSE * sqrt(larger(given->tolerance, LEAST_TOLERANCE));
    int enough = work != NULL;
    if (enough)
        work->near = near < FARTHEST ? near : FARTHEST;
    for (size_t start = 0; enough && start < given->rows; start += CHUNK) {
        const size_t left = given->rows - start;
        const int rows = left < CHUNK ? (int)left : CHUNK;
        enough = solve_chunk(work, given, start, rows, count + start, modes);
    }
    free(work);
    return enough;
}
