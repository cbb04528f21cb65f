/* Seeded properties: the same cases on every machine, each replayable alone. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harness/harness.h"

/* What is running, for the replay line of a failure that leaves by longjmp. */
static const char *running;
static uint64_t running_seed;
static uint32_t running_case;

int harness_after(void **state)
{
    (void)state;
    if (running != NULL) {
        print_error("property \"%s\": replay with VBSS_PROPERTY_SEED=%llu VBSS_PROPERTY_CASE=%u\n",
                    running, (unsigned long long)running_seed, running_case);
        running = NULL;
    }
    return 0;
}

void harness_source_from_bytes(harness_source *source, const uint8_t *bytes, size_t count)
{
    memset(source, 0, sizeof *source);
    source->bytes = bytes;
    source->count = count;
}

uint64_t harness_draw_u64(harness_source *source)
{
    if (source->bytes == NULL) {
        return vbss_random_u64(&source->random);
    }
    uint64_t value = 0;
    for (int i = 0; i < 8 && source->position < source->count; i++) {
        value |= (uint64_t)source->bytes[source->position++] << (8 * i);
    }
    return value;
}

uint32_t harness_draw_below(harness_source *source, uint32_t bound)
{
    return (uint32_t)(harness_draw_u64(source) % bound);
}

double harness_draw_real(harness_source *source, double low, double high)
{
    double t = (double)(harness_draw_u64(source) >> 11) * 0x1p-53;
    return low + t * (high - low);
}

double harness_draw_any_double(harness_source *source)
{
    static const double special[] = {0.0, 1.0, 0x1p-1022, 0x1p-1074, 0x1.fffffffffffffp1023};
    uint64_t bits = harness_draw_u64(source);
    uint32_t choice = harness_draw_below(source, 16);
    double sign = (bits & 1u) != 0 ? -1.0 : 1.0;
    if (choice < 5) {
        return sign * special[choice];
    }
    if (choice < 8) {
        return harness_bad_numbers[choice - 5];
    }
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

vec3 harness_draw_vec3(harness_source *source, double low, double high)
{
    double x = harness_draw_real(source, low, high);
    double y = harness_draw_real(source, low, high);
    double z = harness_draw_real(source, low, high);
    return vec3_make(x, y, z);
}

quat harness_draw_unit_quat(harness_source *source)
{
    quat q;
    do {
        vec3 v = harness_draw_vec3(source, -1.0, 1.0);
        q = quat_make(harness_draw_real(source, -1.0, 1.0), v.x, v.y, v.z);
    } while (quat_dot(q, q) > 1.0 || quat_dot(q, q) < 1e-3);
    return quat_unit(q);
}

void harness_property(const char *name, uint32_t cases, harness_property_fn property, void *user)
{
    const char *seed = getenv("VBSS_PROPERTY_SEED");
    const char *only = getenv("VBSS_PROPERTY_CASE");
    running_seed = seed != NULL ? strtoull(seed, NULL, 10) : 1u;
    uint32_t first = only != NULL ? (uint32_t)strtoul(only, NULL, 10) : 0u;
    uint32_t end = only != NULL ? first + 1u : cases;
    for (running_case = first; running_case < end; running_case++) {
        harness_source source = {0};
        vbss_random_seed(&source.random, running_seed, running_case);
        running = name;
        property(&source, user);
        running = NULL;
    }
}
