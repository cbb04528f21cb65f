using System;
using System.Collections.Generic;
using System.Diagnostics;

namespace VblastSs.Tests
{
    /// <summary>C calls C#; what C# throws never crosses C.</summary>
    public static class CallbackTests
    {
        private sealed class Oops : Exception
        {
        }

        public static void MessagesReachTheLog()
        {
            var messages = new List<string>();
            using (var context = new Context(new ContextConfig { LogLevel = LogLevel.Error, Log = (level, text) => messages.Add(level + " " + text) }))
            {
                GC.Collect();
                Check.Throws<VbssException>(() => new SutureThread(context, new ThreadConfig { Radius = -1 }));
                Check.Equal(1, messages.Count, "messages");
                Check.That(messages[0].StartsWith("Error ") && messages[0].Contains("radius"), messages[0]);
            }
        }

        public static void WhatALogThrowsComesOutOfTheCall()
        {
            using (var context = new Context(new ContextConfig { LogLevel = LogLevel.Error, Log = (level, text) => { throw new Oops(); } }))
            {
                Check.Throws<Oops>(() => new SutureThread(context, new ThreadConfig { Radius = -1 }));
                new SutureThread(context).Dispose();
            }
        }

        public static void AContextCannotBeDisposedInsideItsCallback()
        {
            Context context = null;
            context = new Context(new ContextConfig { LogLevel = LogLevel.Error, Log = (level, text) => context.Dispose() });
            Check.Fails(Result.ErrorBusy, () => new SutureThread(context, new ThreadConfig { Radius = -1 }));
            Check.That(!context.IsDisposed, "alive");
            context.Dispose();
        }

        public static void AnObjectDisposedInsideACallbackIsDestroyedAfterIt()
        {
            SutureThread thread = null;
            using (var context = new Context(new ContextConfig { LogLevel = LogLevel.Error, Log = (level, text) => thread.Dispose() }))
            {
                thread = new SutureThread(context);
                ulong before = context.GetStatistics().ObjectsAlive;
                Check.Throws<VbssException>(() => new SutureThread(context, new ThreadConfig { Radius = -1 }));
                Check.That(thread.IsDisposed, "disposed");
                context.GetStatistics();
                Check.Equal(before - 1, context.GetStatistics().ObjectsAlive, "objects");
            }
        }

        public static void AnAdapterInCSharpDrivesADevice()
        {
            int opened = 0, closed = 0;
            double written = double.NaN;
            var adapter = new DeviceAdapter
            {
                Name = "hand",
                Open = () => { opened++; return Result.Ok; },
                Close = () => closed++,
                Describe = capabilities => { capabilities.Signals = DeviceHasBits.Position; capabilities.Outputs = DeviceOutBits.Force;
                                             capabilities.MaxForce = 3; return Result.Ok; },
                Read = (now, sample) => { sample.Time = now; sample.Position = new Vector3d(0.01 * now, 0, 0); sample.Valid = DeviceHasBits.Position;
                                          return Result.Ok; },
                Write = (now, output) => { written = output.Force.X; return Result.Ok; }
            };
            using (var context = new Context())
            {
                using (var device = new Device(context, adapter, null, null))
                {
                    GC.Collect();
                    DeviceInput input = device.Read(0);
                    for (int i = 1; i < 100; i++)
                    {
                        input = device.Read(i * 1e-3);
                        device.Write(i * 1e-3, new OutputCommand());
                    }
                    Check.That(Math.Abs(input.Position.X - 0.01 * 0.099) < 1e-4, "x = " + input.Position.X);
                    Check.Equal(3.0, device.GetCapabilities(0).MaxForce, "force");
                    Check.Equal(0.0, written, "force");
                }
                Check.That(opened == 1 && closed == 1, "opened " + opened + ", closed " + closed);
            }
        }

        public static void WhatAnAdapterThrowsComesOutOfTheCall()
        {
            var adapter = new DeviceAdapter { Read = (now, sample) => { throw new Oops(); } };
            using (var context = new Context())
            using (var device = new Device(context, adapter, null, null))
            {
                Check.Throws<Oops>(() => device.Read(0));
            }
            using (var context = new Context())
            {
                Check.Throws<Oops>(() => new Device(context, new DeviceAdapter { Open = () => { throw new Oops(); },
                    Read = (now, sample) => Result.Ok }, null, null));
            }
        }

        public static void ASimulatedDeviceMeasuresInCSharp()
        {
            var config = new MockConfig { Measure = (time, sample) =>
            {
                sample.Time = time;
                sample.Position = new Vector3d(0, time, 0);
                sample.Valid = DeviceHasBits.Position;
            } };
            using (var context = new Context())
            {
                Device device;
                using (var mock = new Mock(context, config))
                {
                    device = new Device(context, mock.GetAdapter(), null, null);
                    GC.Collect();
                    device.Read(0);
                    Check.Equal(0.001, device.Read(0.001).Position.Y, "y");
                    device.Dispose();
                }
            }
        }

        public static void ACoreIsMeasuredWithAClockOfTheHost()
        {
            Stopwatch watch = Stopwatch.StartNew();
            using (var context = new Context())
            {
                CoreSpeed speed = CoreSpeed.Measure(context, () => watch.Elapsed.TotalSeconds);
                Check.That(speed.Equals(speed), "measured");
                Check.Throws<Oops>(() => CoreSpeed.Measure(context, () => { throw new Oops(); }));
            }
        }

        public static void EventsOfASessionReachAListener()
        {
            var events = new List<SessionEventKind>();
            using (var context = new Context())
            using (var scene = new Scene(context, new SceneConfig { RigidCapacity = 8 }))
            {
                uint needle = scene.AddNeedle(new Needle(context, new NeedleConfig { Position = new Vector3d(0, 0.1, 0) }));
                uint drain = scene.AddDrain(new Drain(context));
                var config = new SessionConfig { Needle = needle, Drain = drain, Listen = one => events.Add(one.Kind) };
                config.Thread = scene.AddThread(new SutureThread(context, new ThreadConfig { Start = new Vector3d(0, 0.2, 0) }));
                UInts2 tools = config.Tools;
                tools[0] = scene.AddGrasper(new Grasper(context, new GrasperConfig { Trocar = new Vector3d(-0.2, 0.3, 0) }));
                tools[1] = scene.AddGrasper(new Grasper(context, new GrasperConfig { Trocar = new Vector3d(0.2, 0.3, 0) }));
                config.Tools = tools;
                using (var session = new Session(scene, config))
                {
                    GC.Collect();
                    session.Step(0, 1e-3);
                    Check.That(events.Count > 0, "events");
                }
            }
        }
    }
}
