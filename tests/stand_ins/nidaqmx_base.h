/* Names of NI-DAQmx Base for the functions of the stand-in, where it is built as that. Its function that writes lines takes the
 * bits of a port. */
#ifndef VBSS_TESTS_STAND_INS_NIDAQMX_BASE_H
#define VBSS_TESTS_STAND_INS_NIDAQMX_BASE_H

#ifdef STAND_IN_BASE
#define DAQmxCreateTask DAQmxBaseCreateTask
#define DAQmxStartTask DAQmxBaseStartTask
#define DAQmxStopTask DAQmxBaseStopTask
#define DAQmxClearTask DAQmxBaseClearTask
#define DAQmxCreateAIVoltageChan DAQmxBaseCreateAIVoltageChan
#define DAQmxCreateDOChan DAQmxBaseCreateDOChan
#define DAQmxReadAnalogF64 DAQmxBaseReadAnalogF64
#define DAQmxWriteDigitalLines DAQmxBaseWriteDigitalU8
#define DAQmxGetExtendedErrorInfo DAQmxBaseGetExtendedErrorInfo
#endif

#endif
