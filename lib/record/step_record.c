/* Serialises the records of a step and of the end of a log. */
#include "base/memory.h"
#include "record/record.h"

_Static_assert((int)VBSS_RECORD_EVENT_TIME_LOST == (int)SCENE_INSPECT_TIME_LOST &&
                   (int)VBSS_RECORD_EVENT_LOST == (int)SCENE_INSPECT_LOST,
               "the kinds of logged events");

/* Inputs follow one another as they were told; tags of words from 16 on, of numbers from 32. */
enum { WORD_TAGS = 16, NUMBER_TAGS = 32 };

static void visit_inputs(vbss_stream *stream, log_step *step)
{
    vbss_stream_count(stream, 3, &step->input_count, step->input_capacity);
    vbss_stream_u8(stream, 4, step->kinds, step->input_count);
    for (uint32_t i = 0; i < step->input_count && stream->result == VBSS_OK; i++) {
        uint8_t kind = step->kinds[i];
        vbss_record_input *input = &step->inputs[i];
        if (kind == 0 || kind >= LOG_INPUT_KINDS) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such input");
            return;
        }
        const log_input_shape shape = vbss_log_input_shapes[kind];
        input->kind = kind;
        input->word_count = shape.words;
        input->number_count = shape.numbers;
        vbss_stream_u32(stream, (uint16_t)(WORD_TAGS + kind), input->words, shape.words);
        if (shape.numbers > 0) {
            vbss_stream_f64(stream, (uint16_t)(NUMBER_TAGS + kind), input->numbers, shape.numbers);
        }
    }
}

static void visit_events(vbss_stream *stream, log_step *step)
{
    vbss_stream_count(stream, 5, &step->event_count, step->event_capacity);
    if (step->event_count > 0) {
        vbss_stream_u32(stream, 6, step->events[0], 4 * (size_t)step->event_count);
    }
}

static void visit_hash(vbss_stream *stream, log_step *step)
{
    uint64_t words[3] = {step->number, step->has_hash, step->hash};
    vbss_stream_u64(stream, 1, words, 3);
    step->number = words[0];
    step->has_hash = words[1];
    step->hash = words[2];
    if (step->has_hash > 1) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such flag");
    }
}

/* Older libraries read steps whose inputs they know. */
static uint16_t version_of(const vbss_stream *stream, const log_step *step)
{
    enum { SETTINGS = 3, ALL_EDITS = 4 };
    bool is_new = stream->mode == VBSS_STREAM_READ;
    for (uint32_t i = 0; !is_new && i < step->input_count; i++) {
        is_new = step->kinds[i] > VBSS_RECORD_INPUT_SETTING;
    }
    return is_new ? ALL_EDITS : SETTINGS;
}

void vbss_log_visit_step(vbss_stream *stream, log_step *step)
{
    vbss_section outer = vbss_stream_open(stream, LOG_STEP, version_of(stream, step));
    visit_hash(stream, step);
    vbss_stream_f64(stream, 2, &step->h, 1);
    visit_inputs(stream, step);
    visit_events(stream, step);
    vbss_stream_close(stream, outer);
}

void vbss_log_visit_end(vbss_stream *stream, log_step *step)
{
    vbss_section outer = vbss_stream_open(stream, LOG_END, 1);
    visit_hash(stream, step);
    vbss_stream_close(stream, outer);
}

/* ---- memory */

void vbss_log_borrow_events(log_step *step, const scene_info *scene)
{
    step->event_count = scene->event_count;
    step->events = scene->events;
}

vbss_result vbss_log_allocate_events(vbss_context *context, log_step *step, uint32_t capacity)
{
    step->events = vbss_allocate(context, capacity, sizeof *step->events, "events of a log");
    step->event_capacity = capacity;
    return step->events != NULL ? VBSS_OK : VBSS_ERROR_OUT_OF_MEMORY;
}

void vbss_log_free_events(vbss_context *context, log_step *step)
{
    vbss_release(context, step->events, step->event_capacity, sizeof *step->events);
}

static void list_input_arrays(log_step *step, vbss_array arrays[2])
{
    arrays[0] = (vbss_array){&step->kinds, step->input_capacity, sizeof *step->kinds};
    arrays[1] = (vbss_array){&step->inputs, step->input_capacity, sizeof *step->inputs};
}

vbss_result vbss_log_allocate_inputs(vbss_context *context, log_step *step)
{
    vbss_array arrays[2];
    list_input_arrays(step, arrays);
    return vbss_allocate_arrays(context, arrays, 2, "inputs of a log");
}

void vbss_log_free_inputs(vbss_context *context, log_step *step)
{
    vbss_array arrays[2];
    list_input_arrays(step, arrays);
    vbss_release_arrays(context, arrays, 2);
}
