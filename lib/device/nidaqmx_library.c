/* Loads the NI-DAQmx library and interprets its errors. */
#include "base/error.h"
#include "device/nidaqmx.h"

#ifdef _WIN32
static const char *const usual_names[] = {"nicaiu.dll"};
#else
static const char *const usual_names[] = {"libnidaqmx.so.1", "libnidaqmxbase.so"};
#endif
enum { USUAL_NAMES = sizeof usual_names / sizeof usual_names[0] };

/* NI-DAQmx for Linux does not know the cheap USB devices, which have another driver there. */
#ifdef __linux__
#define PLATFORM_HINT                                                                         \
    ". NI-DAQmx for Linux has no USB-6008 or USB-6009: install NI-DAQmx Base, whose library " \
    "is libnidaqmxbase.so, or use Windows"
#else
#define PLATFORM_HINT ""
#endif

/* ---- loading */

static const char *find_functions(daq_functions *daq)
{
    const device_symbol symbols[] = {
        {"DAQmxCreateTask", &daq->create_task},
        {"DAQmxStartTask", &daq->start_task},
        {"DAQmxStopTask", &daq->stop_task},
        {"DAQmxClearTask", &daq->clear_task},
        {"DAQmxCreateAIVoltageChan", &daq->create_voltage_input},
        {"DAQmxCreateDOChan", &daq->create_digital_output},
        {"DAQmxReadAnalogF64", &daq->read_analog},
        {"DAQmxWriteDigitalLines", &daq->write_digital},
        {"DAQmxGetExtendedErrorInfo", &daq->get_extended_error},
        {"DAQmxGetSysDevNames", &daq->get_device_names},
        {"DAQmxGetDevProductType", &daq->get_product},
    };
    return vbss_device_find_symbols(daq->library, symbols, sizeof symbols / sizeof symbols[0]);
}

/* The functions of NI-DAQmx Base have other names, and the same arguments. */
static const char *find_base_functions(daq_functions *daq)
{
    const device_symbol symbols[] = {
        {"DAQmxBaseCreateTask", &daq->create_task},
        {"DAQmxBaseStartTask", &daq->start_task},
        {"DAQmxBaseStopTask", &daq->stop_task},
        {"DAQmxBaseClearTask", &daq->clear_task},
        {"DAQmxBaseCreateAIVoltageChan", &daq->create_voltage_input},
        {"DAQmxBaseCreateDOChan", &daq->create_digital_output},
        {"DAQmxBaseReadAnalogF64", &daq->read_analog},
        {"DAQmxBaseWriteDigitalU8", &daq->write_digital},
        {"DAQmxBaseGetExtendedErrorInfo", &daq->get_extended_error},
    };
    return vbss_device_find_symbols(daq->library, symbols, sizeof symbols / sizeof symbols[0]);
}

vbss_result vbss_nidaqmx_load(vbss_context *context, const char *name, daq_functions *daq)
{
    char text[DEVICE_LOAD_TEXT_BYTES] = "";
    const char *loaded = "";
    daq->library = name != NULL
                       ? vbss_device_load_any(&name, 1, &loaded, text, sizeof text)
                       : vbss_device_load_any(usual_names, USUAL_NAMES, &loaded, text, sizeof text);
    if (daq->library == NULL) {
        return vbss_fail(context, VBSS_ERROR_DEVICE, "NI-DAQmx: %s%s", text,
                         name == NULL ? PLATFORM_HINT : "");
    }
    const char *missing = find_functions(daq);
    if (missing == NULL) {
        return VBSS_OK;
    }
    daq->is_base = find_base_functions(daq) == NULL;
    return daq->is_base
               ? VBSS_OK
               : vbss_fail(context, VBSS_ERROR_DEVICE, "NI-DAQmx: %s has no %s", loaded, missing);
}

/* ---- errors */

static const struct {
    int32_t code;
    daq_remedy remedy;
    const char *name;
} errors[] = {
    {-200221, DAQ_RETRY, "timeout"},
    {-200474, DAQ_RETRY, "timeout of an operation"},
    {-200284, DAQ_RETRY, "no sample in time"},
    {-200279, DAQ_RETRY, "samples were overwritten"},
    {-200292, DAQ_RETRY, "no room for samples in time"},
    {-200293, DAQ_RETRY, "no room for samples"},
    {-50405, DAQ_REOPEN, "USB transfer aborted"},
    {-200361, DAQ_REOPEN, "memory of the device overflowed"},
    {-200222, DAQ_REOPEN, "acquisition stopped, its buffer was full"},
    {-200088, DAQ_REOPEN, "no such task"},
    {-200846, DAQ_REOPEN, "written to while it is stopped"},
    {-200220, DAQ_LOST, "no such device"},
    {-200170, DAQ_LOST, "no such channel"},
    {-200045, DAQ_LOST, "device removed"},
    {-50103, DAQ_LOST, "in use by another program"},
    {-200077, DAQ_LOST, "a setting it does not have"},
    {-200562, DAQ_LOST, "neither 0 nor 1 to a line"},
};

const char *vbss_nidaqmx_error_name(int32_t code)
{
    for (size_t i = 0; i < sizeof errors / sizeof errors[0]; i++) {
        if (errors[i].code == code) {
            return errors[i].name;
        }
    }
    return code == 0 ? "no error" : code > 0 ? "a warning" : "an error without a name";
}

/* After an unknown error the hardware counts as lost. */
daq_remedy vbss_nidaqmx_remedy(int32_t code)
{
    for (size_t i = 0; i < sizeof errors / sizeof errors[0]; i++) {
        if (errors[i].code == code) {
            return errors[i].remedy;
        }
    }
    return code < 0 ? DAQ_LOST : DAQ_FINE;
}

/* On Linux a device that is plugged in can be unknown to this driver. */
static const char *hint_for(const daq_functions *daq, int32_t code)
{
    return code == DAQ_NO_DEVICE && !daq->is_base ? PLATFORM_HINT : "";
}

vbss_result vbss_nidaqmx_check(vbss_context *context, const daq_functions *daq, int32_t code,
                               const char *what)
{
    if (code >= 0) {
        return VBSS_OK;
    }
    char text[256] = "";
    if (daq->get_extended_error(text, sizeof text) < 0) {
        text[0] = '\0';
    }
    text[sizeof text - 1] = '\0';
    for (char *c = text; *c != '\0'; c++) { /* the message must be one line */
        if (*c == '\n' || *c == '\r') {
            *c = ' ';
        }
    }
    const char *hint = hint_for(daq, code);
    return vbss_fail(context, VBSS_ERROR_DEVICE, "NI-DAQmx: %s: %s (%d)%s%s", what,
                     vbss_nidaqmx_error_name(code), code, hint[0] == '\0' ? " " : hint,
                     hint[0] == '\0' ? text : "");
}
