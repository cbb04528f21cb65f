/* The header record of a log: the library that wrote it, the host's note, and the configuration of
 * the scene. */
#include <string.h>

#include "base/error.h"
#include "base/memory.h"
#include "record/record.h"

vbss_result vbss_log_compare_config(const log_header *header, const scene_info *scene)
{
    const char *name = vbss_scene_inspect_config_difference(&header->scene, scene->config);
    return name == NULL ? VBSS_OK
                        : vbss_fail(scene->context, VBSS_ERROR_CORRUPT,
                                    "the scene's %s is not that of the log", name);
}

/* ---- blobs */

vbss_result vbss_log_make_blob(vbss_context *context, log_blob *blob, const void *bytes,
                               size_t count)
{
    blob->bytes = vbss_allocate(context, count + 1, 1, "part of a log");
    if (blob->bytes == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    blob->count = (uint32_t)count;
    if (count > 0 && bytes != NULL) {
        memcpy(blob->bytes, bytes, count);
    }
    return VBSS_OK;
}

static void free_blob(vbss_context *context, log_blob *blob)
{
    vbss_release(context, blob->bytes, (size_t)blob->count + 1, 1);
    *blob = (log_blob){0};
}

static void visit_blob(vbss_stream *stream, uint16_t tag, vbss_context *context, log_blob *blob)
{
    uint32_t count = blob->count, max_count = UINT32_MAX;
    bool reading = stream->mode == VBSS_STREAM_READ;
    if (reading && stream->capacity - stream->position < max_count) {
        max_count = (uint32_t)(stream->capacity - stream->position);
    }
    vbss_stream_count(stream, tag, &count, max_count);
    if (reading && stream->result == VBSS_OK &&
        vbss_log_make_blob(context, blob, NULL, count) != VBSS_OK) {
        vbss_stream_refuse(stream, VBSS_ERROR_OUT_OF_MEMORY, "no memory for a part of the log");
    }
    vbss_stream_u8(stream, (uint16_t)(tag + 1), blob->bytes, count);
}

/* ---- header record */

void vbss_log_visit_header(vbss_stream *stream, log_header *header)
{
    vbss_section outer = vbss_stream_open(stream, LOG_HEADER, 1);
    vbss_stream_u32(stream, 1, &header->library_version, 1);
    visit_blob(stream, 2, header->context, &header->build_info);
    vbss_stream_u32(stream, 4, &header->hash_interval, 1);
    if (header->hash_interval == 0) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such interval");
    }
    vbss_stream_count(stream, 5, &header->input_capacity, 65536);
    visit_blob(stream, 6, header->context, &header->note);
    vbss_scene_inspect_visit_config(stream, &header->scene, &header->baseline, &header->solver);
    if (header->scene.event_capacity > 65536) { /* a reader allocates room for them */
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no scene keeps so many events");
    }
    vbss_stream_close(stream, outer);
}

void vbss_log_free_header(log_header *header)
{
    free_blob(header->context, &header->build_info);
    free_blob(header->context, &header->note);
}
