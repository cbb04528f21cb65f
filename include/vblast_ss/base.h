/**
 * @file base.h
 * @brief Foundation of libvblast_ss: results, version, and the context that owns every object.
 *
 * Conventions of the whole library:
 * - Units are SI everywhere; the name of a metric in millimetres ends in `_mm`.
 * - Functions return a #vbss_result and write results through pointers. The few that cannot fail
 *   (texts, version) return their value.
 * - Pointers must not be NULL unless the parameter's comment allows it.
 * - A failed call has changed nothing; #vbss_context_get_last_error returns the reason.
 * - One thread at a time may use a context. A call from another thread, while one is inside the
 *   context, returns #VBSS_ERROR_BUSY. It leaves no error text, as the text belongs to the thread
 *   inside.
 * - A callback may call functions that only read its context. Functions that would change the context
 *   return #VBSS_ERROR_BUSY.
 * - Each call sets the floating-point mode that it needs: rounding to nearest, subnormal numbers kept,
 *   all exceptions masked. It restores the mode of the host when it returns, and while a function of
 *   the host runs. Results are therefore the same in every mode. A call may raise sticky exception
 *   flags. On processors whose mode the library cannot set, a call in another mode returns
 *   #VBSS_ERROR_ARITHMETIC_MODE; the library can set it on x86 with SSE2, ARM, RISC-V and s390x.
 * - The library never aborts, prints, starts threads, or keeps global state.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_BASE_H
#define VBLAST_SS_BASE_H

#include <stdint.h>

/** Major version: a change breaks the ABI. */
#define VBSS_VERSION_MAJOR 1
/** Minor version: new functions, fields and constants. */
#define VBSS_VERSION_MINOR 0
/** Patch version: fixes only. */
#define VBSS_VERSION_PATCH 0
/** Suffix of a pre-release, such as "-rc1"; empty in a release. #VBSS_VERSION_NUM does not contain it. */
#define VBSS_VERSION_SUFFIX "-rc1"
/** Version of these headers as one number, 10000 major + 100 minor + patch. */
#define VBSS_VERSION_NUM \
    (VBSS_VERSION_MAJOR * 10000 + VBSS_VERSION_MINOR * 100 + VBSS_VERSION_PATCH)

/** Marks a function exported from the shared library. */
#if defined(_WIN32) && defined(VBSS_BUILDING_SHARED)
#define VBSS_API __declspec(dllexport)
#elif defined(_WIN32) && defined(VBSS_USING_SHARED)
#define VBSS_API __declspec(dllimport)
#elif defined(__GNUC__)
#define VBSS_API __attribute__((visibility("default")))
#else
#define VBSS_API
#endif

/**
 * Marks a function that a later major version of the library will not have. A call makes the compiler
 * warn with `text`, such as "use vbss_scene_step". A program that defines VBSS_NO_DEPRECATED before it
 * includes the headers gets no such warnings. docs/reference/abi.md has the policy.
 */
#if defined(VBSS_NO_DEPRECATED)
#define VBSS_DEPRECATED(text)
#elif defined(__GNUC__)
#define VBSS_DEPRECATED(text) __attribute__((deprecated(text)))
#elif defined(_MSC_VER)
#define VBSS_DEPRECATED(text) __declspec(deprecated(text))
#else
#define VBSS_DEPRECATED(text)
#endif

/**
 * Every status: X(name, pinned number, text). Numbers are never reused or changed; new ones are
 * appended.
 */
#define VBSS_RESULTS(X)                                                                           \
    X(VBSS_OK, 0, "success")                                                                      \
    X(VBSS_ERROR_NULL_ARGUMENT, -1, "a required pointer is NULL")                                 \
    X(VBSS_ERROR_OUT_OF_RANGE, -2, "an argument is outside its range")                            \
    X(VBSS_ERROR_NOT_FINITE, -3, "an argument is NaN or infinite")                                \
    X(VBSS_ERROR_STRUCT_SIZE, -4, "struct_size is no size that the struct has had or could have") \
    X(VBSS_ERROR_UNKNOWN_FIELD, -5, "a field unknown to this library version is not zero")        \
    X(VBSS_ERROR_INVALID_HANDLE, -6, "the handle is NULL, destroyed or of another type")          \
    X(VBSS_ERROR_OUT_OF_MEMORY, -7, "the allocator gave no usable block")                         \
    X(VBSS_ERROR_CAPACITY, -8, "a capacity fixed at creation or a given buffer is exhausted")     \
    X(VBSS_ERROR_BUSY, -9, "another thread, or the caller of this callback, uses the context")    \
    X(VBSS_ERROR_ARITHMETIC_MODE, -10,                                                            \
      "rounding is not to nearest or subnormal numbers are flushed to zero")                      \
    X(VBSS_ERROR_TRUNCATED, -11, "the data end too early")                                        \
    X(VBSS_ERROR_CORRUPT, -12, "the data are damaged or not what this call reads")                \
    X(VBSS_ERROR_DATA_VERSION, -13, "the data were written by a newer version of the library")    \
    X(VBSS_ERROR_IN_SCENE, -14, "not allowed while the object belongs to a scene")                \
    X(VBSS_ERROR_DEVICE, -15, "a device failed, or is not there")                                 \
    X(VBSS_ERROR_CLOCK_STOPPED, -16, "the host's clock does not advance")                         \
    X(VBSS_ERROR_CLOCK_JUMPED, -17, "the host's clock runs backwards or jumps")                   \
    X(VBSS_ERROR_CLOCK_COARSE, -18, "the host's clock is too coarse")                             \
    X(VBSS_ERROR_NOT_FOUND, -19,                                                                  \
      "the object, entry or step that an argument names does not exist")                          \
    X(VBSS_ERROR_WRONG_STATE, -20, "the object is not in a state that allows the call")           \
    X(VBSS_ERROR_INCOMPATIBLE, -21, "an object or a setting does not fit the others of the call") \
    X(VBSS_ERROR_IN_USE, -22, "something else already uses what an argument names")

/**
 * Status of a call: VBSS_OK (0) or a negative VBSS_ERROR_ constant. Refusals differ by what the host
 * can do about them (docs/reference/abi.md). VBSS_ERROR_OUT_OF_RANGE concerns numbers alone, also constants
 * that do not exist, and indices of nodes, edges and triangles.
 */
typedef int32_t vbss_result;

/** The constants of #vbss_result, one for each row of #VBSS_RESULTS. */
enum {
#define VBSS_RESULT_CONSTANT(name, number, text) name = (number),
    VBSS_RESULTS(VBSS_RESULT_CONSTANT)
#undef VBSS_RESULT_CONSTANT
};

/** Importance of a log message: a VBSS_LOG_ constant; a larger number is less important. */
typedef int32_t vbss_log_level;

/** The constants of #vbss_log_level. */
enum {
    VBSS_LOG_NONE = 0,    /**< As a limit: no messages at all. */
    VBSS_LOG_ERROR = 1,   /**< A call failed; the message is its error text. */
    VBSS_LOG_WARNING = 2, /**< A setting is probably not the intended one. */
    VBSS_LOG_INFO = 3     /**< Rare milestones, such as the creation of a context. */
};

/** Method of computation of an object: a VBSS_METHOD_ constant. */
typedef int32_t vbss_method;

/** The constants of #vbss_method. */
enum {
    VBSS_METHOD_IMPLICIT = 0, /**< The library's own method, the default. */
    VBSS_METHOD_VBLAST = 1    /**< The method of VBLaST-SS (Qi et al. 2017), as a baseline. */
};

/** Type of the values of a view: a VBSS_VIEW_TYPE_ constant. */
typedef int32_t vbss_view_type;

/** The constants of #vbss_view_type. */
enum {
    VBSS_VIEW_TYPE_F64 = 1, /**< double */
    VBSS_VIEW_TYPE_U32 = 2, /**< uint32_t */
    VBSS_VIEW_TYPE_F32 = 3  /**< float, of 32 bits; only in meshes for drawing */
};

/**
 * A read-only array inside the library. Item i starts `i * stride_bytes` after data and has
 * `components` contiguous values of the type. It is valid until the next step, edit or destruction
 * of its object; a step or an edit changes the generation.
 */
typedef struct vbss_view {
    uint32_t struct_size;  /**< Bytes of this struct that the library filled. */
    vbss_view_type type;   /**< Type of each value. */
    uint32_t components;   /**< Number of values in an item, such as 3 for a vector. */
    uint32_t stride_bytes; /**< Distance from one item to the next, bytes. */
    uint64_t count;        /**< Number of items. */
    const void *data;      /**< The first item; never NULL. */
    uint64_t generation;   /**< Number that changes with every step or edit of the object. */
} vbss_view;

/** Owner of all objects, their memory and their error texts. One thread at a time may use it; the
 * library detects a second one (#VBSS_ERROR_BUSY). */
typedef struct vbss_context vbss_context;

/**
 * Allocates memory for a context. The function must return (no longjmp, no exception). Its calls
 * that would change the same context return VBSS_ERROR_BUSY.
 *
 * @param user       the context's allocator_user; may be NULL
 * @param size       bytes wanted, > 0
 * @param alignment  alignment in bytes, a power of two
 * @return the block, or NULL when there is no memory; its contents are arbitrary; the library
 *         releases a block that is not aligned and treats it as NULL
 */
typedef void *(*vbss_allocate_fn)(void *user, uint64_t size, uint64_t alignment);

/**
 * Releases a block of a #vbss_allocate_fn. The function must return (no longjmp, no exception). Its
 * calls that would change the same context return VBSS_ERROR_BUSY.
 *
 * @param user       the context's allocator_user; may be NULL
 * @param block      the block, never NULL
 * @param size       its size at allocation, bytes
 * @param alignment  its alignment at allocation, bytes
 */
typedef void (*vbss_deallocate_fn)(void *user, void *block, uint64_t size, uint64_t alignment);

/**
 * Receives log messages, on the thread that called the library. The function must return (no
 * longjmp, no exception). Its calls that would change the same context return VBSS_ERROR_BUSY.
 *
 * @param user     the context's log_user; may be NULL
 * @param level    importance
 * @param message  UTF-8 text without a newline, valid during the call only
 */
typedef void (*vbss_log_fn)(void *user, vbss_log_level level, const char *message);

/** Configuration of a context. Fill it with #vbss_context_config_init, then change fields. */
typedef struct vbss_context_config {
    uint32_t struct_size;     /**< Size of this struct in bytes, set by the init function. */
    vbss_log_level log_level; /**< Least important level that is sent; default VBSS_LOG_WARNING. */
    /** Allocator; NULL (default): the C library; set both functions or neither. */
    vbss_allocate_fn allocate;
    /** Counterpart of allocate; NULL (default): the C library; set both functions or neither. */
    vbss_deallocate_fn deallocate;
    void *allocator_user; /**< Pointer that allocate and release receive; may be NULL. */
    vbss_log_fn log;      /**< Function for log messages; NULL (default): messages are dropped. */
    void *log_user;       /**< Pointer that log receives; may be NULL. */
} vbss_context_config;

/** Memory and objects of a context. */
typedef struct vbss_context_statistics {
    uint32_t struct_size;      /**< Bytes of this struct that the library filled. */
    uint32_t reserved;         /**< Zero. */
    uint64_t bytes_allocated;  /**< Memory currently allocated, bytes. */
    uint64_t bytes_peak;       /**< Largest value of bytes_allocated so far, bytes. */
    uint64_t allocation_count; /**< Successful calls of the allocator so far. */
    uint64_t objects_alive;    /**< Objects created and not yet destroyed. */
    uint64_t objects_created;  /**< Objects created so far; the last creation ordinal. */
} vbss_context_statistics;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Returns the version of the running library, in the form of #VBSS_VERSION_NUM.
 *
 * @return 10000 major + 100 minor + patch
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API uint32_t vbss_version(void);

/**
 * Returns build information: version with its suffix, source revision, compiler, and the flags that matter for
 * reproducible results.
 *
 * @return a constant text, never NULL
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API const char *vbss_build_info(void);

/**
 * Returns the name of a status, such as "VBSS_ERROR_CAPACITY".
 *
 * @param result  any number
 * @return a constant text, never NULL; "unknown result" for any other number
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API const char *vbss_result_name(vbss_result result);

/**
 * Returns a description of a status.
 *
 * @param result  any number
 * @return a constant text, never NULL; "unknown result" for any other number
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API const char *vbss_result_string(vbss_result result);

/**
 * Checks whether the calling thread rounds to nearest and keeps subnormal numbers. Hosts linked
 * with fast-math flags often flush them to zero. The library computes in its own mode, so the
 * answer concerns the arithmetic of the host only, such as the computation of poses.
 *
 * @return VBSS_OK or VBSS_ERROR_ARITHMETIC_MODE
 * @threads any thread, any time; the answer is for the calling thread
 * @since 1.0
 */
VBSS_API vbss_result vbss_arithmetic_check(void);

/**
 * Fills a context configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_context_config_init(vbss_context_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_context_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_context_config vbss_context_config_default(void)
{
    vbss_context_config vbss_filled;
    (void)vbss_context_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Creates a context.
 *
 * @param config        configuration; NULL for the defaults
 * @param[out] context  the new context; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 *         VBSS_ERROR_OUT_OF_RANGE (log_level, or only one of allocate and release) or
 *         VBSS_ERROR_OUT_OF_MEMORY
 * @threads any thread; contexts are independent of each other
 * @since 1.0
 */
VBSS_API vbss_result vbss_context_create(const vbss_context_config *config, vbss_context **context);

/**
 * Destroys a context and every object in it, youngest first. Afterwards neither the context nor any
 * of its handles may be used.
 *
 * @param context  the context; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY (called from a callback of its own, or
 *         while another thread is inside)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_context_destroy(vbss_context *context);

/**
 * Returns the last failure in this context. A successful call does not clear it. The following
 * failures are reported by their status alone: a call inside a callback of the context, a call from
 * a second thread, and a size query (a call of a save function without a buffer).
 *
 * @param context      the context
 * @param[out] result  its status, VBSS_OK when nothing has failed yet; may be NULL
 * @param[out] text    its text, which names the argument and the value that was refused; empty when
 *                     nothing has failed yet; valid until the next failure in this context; may be
 *                     NULL
 * @return VBSS_OK or VBSS_ERROR_INVALID_HANDLE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_context_get_last_error(const vbss_context *context, vbss_result *result,
                                                 const char **text);

/**
 * Returns the memory and objects of a context.
 *
 * @param context          the context
 * @param[out] statistics  receives the statistics
 * @param struct_size      `sizeof *statistics` as the caller was compiled; fields that the library
 *         does not know become zero
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_context_get_statistics(vbss_context *context,
                                                 vbss_context_statistics *statistics,
                                                 uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
