/* Graded mesh: rest lengths that are finest at one point and grow away from it. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "thread/thread.h"

enum { MAX_SEGMENTS = 65536 };

/* Segments on one side of the centre. Their lengths are finest * ratio^k, at most the coarsest,
 * times the scale. */
typedef struct side {
    double distance, ratio, scale;
    uint32_t count;
} side;

static double next_length(double l, double coarsest, double ratio)
{
    return l * ratio < coarsest ? l * ratio : coarsest;
}

static double total_length(uint32_t count, double finest, double coarsest, double ratio)
{
    double sum = 0.0, l = finest;
    for (uint32_t k = 0; k < count; k++) {
        sum += l;
        l = next_length(l, coarsest, ratio);
    }
    return sum;
}

/* Finds the smallest number of segments that covers the distance with the given ratio, then a
 * smaller ratio with which they fit. If they are too long even with ratio 1, they are scaled.
 * False: too many segments. */
static bool fit_segments(side *s, double finest, double coarsest, double ratio)
{
    double sum = 0.0, l = finest;
    for (s->count = 0; sum < s->distance; s->count++) {
        if (s->count == MAX_SEGMENTS) {
            return false;
        }
        sum += l;
        l = next_length(l, coarsest, ratio);
    }
    double low = 1.0, high = ratio;
    for (int k = 0; k < 60; k++) {
        double middle = 0.5 * (low + high);
        if (total_length(s->count, finest, coarsest, middle) < s->distance) {
            low = middle;
        } else {
            high = middle;
        }
    }
    s->ratio = high;
    s->scale = s->count > 0 ? s->distance / total_length(s->count, finest, coarsest, high) : 1.0;
    return true;
}

vbss_result vbss_thread_grade_lengths(double length, double centre, double finest, double coarsest,
                                      double ratio, double *rest_lengths, uint32_t capacity,
                                      uint32_t *count)
{
    VBSS_ENTER(NULL);
    VBSS_TRY(vbss_check_pointer(NULL, count, "count"));
    *count = 0;
    VBSS_TRY(vbss_check_range(NULL, length, 1e-6, 1e3, "length"));
    VBSS_TRY(vbss_check_range(NULL, centre, 0.0, length, "centre"));
    VBSS_TRY(vbss_check_range(NULL, coarsest, 2e-7, length, "coarsest"));
    VBSS_TRY(vbss_check_range(NULL, finest, 2e-7, coarsest, "finest"));
    VBSS_TRY(vbss_check_range(NULL, ratio, 1.0, 2.0, "ratio"));
    /* A centre very close to an end counts as that end, or a much finer segment would remain. */
    double low_end = centre < 0.5 * finest ? 0.0 : centre;
    double split = length - low_end < 0.5 * finest ? length : low_end;
    side low = {split, 1.0, 1.0, 0}, high = {length - split, 1.0, 1.0, 0};
    if (!fit_segments(&low, finest, coarsest, ratio) ||
        !fit_segments(&high, finest, coarsest, ratio) || low.count + high.count > MAX_SEGMENTS) {
        return VBSS_ERROR_CAPACITY;
    }
    *count = low.count + high.count;
    if (*count > capacity) {
        return VBSS_ERROR_CAPACITY;
    }
    VBSS_TRY(vbss_check_pointer(NULL, rest_lengths, "rest_lengths"));
    double l = finest;
    for (uint32_t k = 0; k < low.count; k++) {
        rest_lengths[low.count - 1 - k] = l * low.scale;
        l = next_length(l, coarsest, low.ratio);
    }
    l = finest;
    for (uint32_t k = 0; k < high.count; k++) {
        rest_lengths[low.count + k] = l * high.scale;
        l = next_length(l, coarsest, high.ratio);
    }
    return VBSS_OK;
}
