/* The ground every module stands on: failing, allocating, handles, numbers, saving.
 *
 * The one private header of lib/base. Functions are prefixed vbss_ because a static library shows
 * them to the linker; inline vector algebra (base/linear.h) is not. Nothing here is thread-safe
 * beyond "one thread at a time per context". */
#ifndef VBSS_BASE_BASE_H
#define VBSS_BASE_BASE_H

#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <vblast_ss/base.h>
#include <vblast_ss/elementary.h>

#include "base/linear.h"

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "-ffast-math breaks the argument reductions and exact sums of this library"
#endif
/* Excess precision (x87: 2) would give other bits. 1 (s390x by default) widens float only, which is
 * not used here. */
#if defined(FLT_EVAL_METHOD)
_Static_assert(FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 1, "double must be evaluated in double");
#endif
_Static_assert(sizeof(double) == 8 && DBL_MANT_DIG == 53, "double must be IEEE 754 binary64");

/* Returns a failure to the caller at once. */
#define VBSS_TRY(call)                \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

#if defined(__GNUC__)
#define VBSS_PRINTF(format_index, first_index) \
    __attribute__((format(printf, format_index, first_index)))
#else
#define VBSS_PRINTF(format_index, first_index)
#endif

/* For functions whose constant arguments shall be known inside; and for what shall stay out of the way
 * of what is asked more often. */
#if defined(__GNUC__)
#define VBSS_ALWAYS_INLINE static inline __attribute__((always_inline))
#define VBSS_NEVER_INLINE static __attribute__((noinline))
#else
#define VBSS_ALWAYS_INLINE static inline
#define VBSS_NEVER_INLINE static
#endif

/* ---- failing (message.c): keeps the code and a text that names argument and value, returns the
 * code. A NULL context is allowed: then there is nobody to keep the text. */
vbss_result vbss_fail(vbss_context *context, vbss_result result, const char *format, ...)
    VBSS_PRINTF(3, 4);
void vbss_message(vbss_context *context, vbss_log_level level, const char *format, ...)
    VBSS_PRINTF(3, 4);
/* Around every call of a function of the host: until the end, calls that would change the context
 * are VBSS_ERROR_BUSY. Callbacks nest; `end` takes what `begin` returned. */
bool vbss_callback_begin(vbss_context *context);
void vbss_callback_end(vbss_context *context, bool outer);

/* ---- checking arguments (config.c) */
vbss_result vbss_check_pointer(vbss_context *context, const void *pointer, const char *name);
vbss_result vbss_check_finite(vbss_context *context, const double *values, size_t count,
                              const char *name);
/* low <= value <= high; NaN and infinities are VBSS_ERROR_NOT_FINITE. */
vbss_result vbss_check_range(vbss_context *context, double value, double low, double high,
                             const char *name);
/* The largest absolute value; NaN counts as nothing. */
double vbss_largest(const double *values, size_t count);
/* Three finite numbers, none of them larger than the bound. */
vbss_result vbss_check_vector(vbss_context *context, const double v[3], double bound,
                              const char *name);

/* What every step asks first: VBSS_ERROR_ARITHMETIC_MODE, with a text. */
vbss_result vbss_check_arithmetic(vbss_context *context);
/* A unit quaternion of one of any length from 1e-100 to 1e100. */
vbss_result vbss_read_orientation(vbss_context *context, const double q[4], quat *orientation);

/* ---- structs that cross the border (config.c): the size protocol of docs/abi.md.
 * Each starts with uint32_t struct_size. */
typedef struct vbss_layout {
    const char *name;
    const void *defaults;  /* of a config; NULL for a struct that only goes out */
    const uint32_t *sizes; /* of all published versions, ascending, the last is today's; then 0 */
} vbss_layout;
vbss_result vbss_config_init(const vbss_layout *layout, void *config, uint32_t struct_size);
/* Fills `own` (of today's size) with the defaults and copies a caller's config over them. */
vbss_result vbss_config_read(vbss_context *context, const vbss_layout *layout, const void *config,
                             void *own);
extern const vbss_layout vbss_view_layout;
/* Hands out a struct that the caller may know in another size. */
vbss_result vbss_struct_write(vbss_context *context, const vbss_layout *layout, const void *own,
                              void *out, uint32_t struct_size);

/* ---- memory (memory.c): zeroed arrays, aligned for the wide lanes, given back with their size.
 * NULL always means failure, and the context holds the error; an empty array is a block too.
 * Releasing NULL is nothing. */
#define VBSS_ALIGNMENT 64u
void *vbss_allocate(vbss_context *context, size_t count, size_t size, const char *what);
void vbss_release(vbss_context *context, void *block, size_t count, size_t size);
/* Many arrays of one object, from a table that says what there is. Those that could not be had are NULL
 * if the object was zeroed; release them all the same. */
typedef struct vbss_array {
    void *pointer; /* address of the object's pointer to the array */
    size_t count, size;
} vbss_array;
vbss_result vbss_allocate_arrays(vbss_context *context, const vbss_array *arrays, size_t count,
                                 const char *what);
void vbss_release_arrays(vbss_context *context, const vbss_array *arrays, size_t count);

/* ---- arena (arena.c): memory for one step, taken from one block allocated beforehand. */
typedef struct vbss_arena {
    unsigned char *block;
    size_t capacity, used, peak; /* peak: the most that was taken or asked for */
} vbss_arena;
/* The part of the capacity that an array takes: sum these to size an arena. SIZE_MAX / 4 for what
 * no memory holds. */
size_t vbss_arena_need(size_t count, size_t size);
vbss_result vbss_arena_create(vbss_context *context, vbss_arena *arena, size_t capacity);
void vbss_arena_destroy(vbss_context *context, vbss_arena *arena);
/* Not cleared; aligned to VBSS_ALIGNMENT; NULL always means that the arena is full. */
void *vbss_arena_take(vbss_arena *arena, size_t count, size_t size);
/* Forgets everything taken since `mark`, a value of arena->used; 0 at the start of a step. */
void vbss_arena_rewind(vbss_arena *arena, size_t mark);

/* ---- handles (slot.c). A public handle is a slot in disguise. Slots belong to the context and are
 * never used twice, so a destroyed handle is told and never read as something else. */
typedef struct vbss_stream vbss_stream;
typedef struct vbss_kind {
    const char *name; /* for error texts */
    uint32_t code;    /* four-character code of its section in a snapshot */
    uint16_t version; /* of that section */
    void (*destroy)(vbss_context *context, void *object);
    void (*serialise)(vbss_stream *stream, void *object); /* visits every field of the state */
} vbss_kind;
typedef struct vbss_slot {
    uint32_t tag;
    uint32_t state;
    const vbss_kind *kind;
    vbss_context *context;
    void *object;
    uint64_t ordinal;  /* order of creation in the context: the object's identity in logs */
    const void *owner; /* the object that has it, which alone may step or end it; NULL: the host */
} vbss_slot;
/* Puts a finished object behind a new handle; on failure the caller still owns the object. */
vbss_result vbss_slot_create(vbss_context *context, const vbss_kind *kind, void *object,
                             vbss_slot **slot);
/* The same in two parts, for objects that come to life where nothing may be allocated: a reserved
 * slot waits, as no handle of anybody, until it is filled or the context ends. */
vbss_result vbss_slot_reserve(vbss_context *context, const vbss_kind *kind, vbss_slot **slot);
void vbss_slot_fill(vbss_slot *slot, void *object);
/* It waits again: the object is still there, but its handle is none until the slot is filled with it. */
void vbss_slot_empty(vbss_slot *slot);
/* The slot of a living handle of that kind; any other handle is VBSS_ERROR_INVALID_HANDLE. */
vbss_result vbss_slot_open(const void *handle, const vbss_kind *kind, vbss_slot **slot);
/* The same for a call that changes something: VBSS_ERROR_BUSY inside a callback of the context. */
vbss_result vbss_slot_edit(void *handle, const vbss_kind *kind, vbss_slot **slot);
/* The same for what only the host may do while nobody else has the object: VBSS_ERROR_IN_SCENE. */
vbss_result vbss_slot_edit_unowned(void *handle, const vbss_kind *kind, vbss_slot **slot);
/* Destroys the object; the handle is told from then on. NULL is VBSS_OK. */
vbss_result vbss_slot_destroy(void *handle, const vbss_kind *kind);
/* A handle for an object inside another, which uses it by its public functions. The context does not know
 * it: whoever made the object ends it. */
vbss_slot vbss_slot_inside(vbss_context *context, const vbss_kind *kind, void *object);
/* A context pointer from the host, to look at or to change what it owns. */
vbss_result vbss_context_open(const vbss_context *context);
vbss_result vbss_context_edit(vbss_context *context);

/* ---- hash (hash.c): XXH64 with seed 0, so that any xxhash tool can check a file. */
typedef struct vbss_hash {
    uint64_t lanes[4];
    uint64_t length;
    uint8_t pending[32];
} vbss_hash;
void vbss_hash_begin(vbss_hash *hash);
void vbss_hash_add(vbss_hash *hash, const void *bytes, size_t count);
uint64_t vbss_hash_end(const vbss_hash *hash);

/* ---- stream (stream.c): one visitor writes, measures, hashes and reads a state.
 *
 * A body has one function that visits its fields in order; the stream's mode decides what a visit
 * does. The bytes are little-endian on every machine and self-describing:
 *   section  u16 0xfffe, u16 version, u32 code;  field  u16 tag, u8 type, u8 0, u32 count, values;
 *   section end  u16 0xffff, u16 0, u32 0.
 * The first failure is kept in `result` and turns all later visits into nothing, so a visitor reads
 * top to bottom without tests. A field that came with version k is visited if stream->version >= k,
 * and set to its default otherwise; data of a newer version are refused. Signed zeros are kept; any
 * NaN is written as the one quiet NaN; reading a value that is not finite is VBSS_ERROR_CORRUPT. */
typedef enum vbss_stream_mode {
    VBSS_STREAM_MEASURE,
    VBSS_STREAM_WRITE,
    VBSS_STREAM_HASH,
    VBSS_STREAM_READ
} vbss_stream_mode;
struct vbss_stream {
    vbss_stream_mode mode;
    vbss_result result;
    const char *problem; /* what went wrong, a constant text */
    uint32_t section;    /* code of the innermost open section, for error texts */
    uint16_t version;    /* its version: when reading, the one it was written with */
    uint16_t tag;        /* the field visited last */
    bool trusted;        /* our own bytes of a moment ago: visitors cannot refuse what they hold */
    uint8_t *out;
    const uint8_t *in;
    size_t capacity, position; /* in bytes; position counts in every mode */
    vbss_hash hash;
};
void vbss_stream_begin_measure(vbss_stream *stream);
void vbss_stream_begin_write(vbss_stream *stream, uint8_t *bytes, size_t capacity);
void vbss_stream_begin_hash(vbss_stream *stream);
void vbss_stream_begin_read(vbss_stream *stream, const uint8_t *bytes, size_t count);
/* What the caller restores when it closes the section. */
typedef struct vbss_section {
    uint32_t code;
    uint16_t version;
} vbss_section;
vbss_section vbss_stream_open(vbss_stream *stream, uint32_t code, uint16_t version);
void vbss_stream_close(vbss_stream *stream, vbss_section outer);
void vbss_stream_f64(vbss_stream *stream, uint16_t tag, double *values, size_t count);
void vbss_stream_u64(vbss_stream *stream, uint16_t tag, uint64_t *values, size_t count);
void vbss_stream_u32(vbss_stream *stream, uint16_t tag, uint32_t *values, size_t count);
void vbss_stream_i32(vbss_stream *stream, uint16_t tag, int32_t *values, size_t count);
void vbss_stream_u8(vbss_stream *stream, uint16_t tag, uint8_t *values, size_t count);
/* Bytes without a copy: where they lie in what is read, or where to put them in what is written, before the
 * next visit; NULL otherwise. */
const uint8_t *vbss_stream_find_u8(vbss_stream *stream, uint16_t tag, size_t count);
uint8_t *vbss_stream_place_u8(vbss_stream *stream, uint16_t tag, size_t count);
/* A number of array entries that must not exceed what the body has room for, in any mode. */
void vbss_stream_count(vbss_stream *stream, uint16_t tag, uint32_t *value, uint32_t capacity);
/* A value that must be what it was when the state was saved, such as a node count fixed by the
 * configuration: anything else means the state belongs to another object. */
void vbss_stream_same(vbss_stream *stream, uint16_t tag, uint64_t value);
void vbss_stream_same_f64(vbss_stream *stream, uint16_t tag, double value); /* to the bit */
/* For visitors that find nonsense themselves: keeps the first problem. */
void vbss_stream_refuse(vbss_stream *stream, vbss_result result, const char *problem);
/* Four characters as the code of a section. */
#define VBSS_CODE(a, b, c, d) \
    ((uint32_t)(a) | ((uint32_t)(b) << 8) | ((uint32_t)(c) << 16) | ((uint32_t)(d) << 24))

/* ---- snapshots (snapshot.c): the state of one object as bytes with magic, length and checksum. */
vbss_result vbss_snapshot_size(const vbss_slot *slot, size_t *bytes);
vbss_result vbss_snapshot_save(const vbss_slot *slot, uint8_t *bytes, size_t capacity,
                               size_t *written);
/* All or nothing: on any failure the object is as it was. */
vbss_result vbss_snapshot_restore(vbss_slot *slot, const uint8_t *bytes, size_t count);
vbss_result vbss_snapshot_hash(const vbss_slot *slot, uint64_t *hash);
/* The same as hosts ask for them, with their arguments checked: of any kind of object. */
vbss_result vbss_object_save(const void *handle, const vbss_kind *kind, uint8_t *bytes,
                             uint64_t capacity, uint64_t *written);
vbss_result vbss_object_restore(const void *handle, const vbss_kind *kind, const uint8_t *bytes,
                                uint64_t count);
vbss_result vbss_object_hash(const void *handle, const vbss_kind *kind, uint64_t *hash);

/* ---- random numbers (random.c): PCG32, XSH-RR output. */
typedef struct vbss_random {
    uint64_t state, increment;
} vbss_random;
void vbss_random_seed(vbss_random *random, uint64_t seed, uint64_t sequence);
uint32_t vbss_random_u32(vbss_random *random);
uint64_t vbss_random_u64(vbss_random *random);
uint32_t vbss_random_below(vbss_random *random, uint32_t bound); /* unbiased; bound > 0 */
double vbss_random_uniform(vbss_random *random);                 /* [0, 1), 53 bits */
double vbss_random_normal(vbss_random *random);                  /* mean 0, deviation 1 */
vec3 vbss_random_direction(vbss_random *random);                 /* uniform on the unit sphere */
void vbss_random_serialise(vbss_stream *stream, uint16_t tag, vbss_random *random);

/* ---- elementary functions that hosts do not need, as those of vblast_ss/elementary.h: the same bits
 * everywhere. Errors and methods stand in docs/elementary-functions.md. */
void vbss_sincos(double x, double *sine, double *cosine);
double vbss_exp(double x);
double vbss_log(double x); /* natural logarithm */

/* ---- rotations that need elementary functions (rotation.c); rotation vectors in rad */
quat vbss_quat_from_rotation_vector(vec3 rotation);
vec3 vbss_quat_to_rotation_vector(quat q); /* |rotation| <= pi */
/* Orientation after turning with angular velocity omega (world frame, rad/s) for h seconds. */
quat vbss_quat_integrate(quat q, vec3 omega, double h);

#endif
