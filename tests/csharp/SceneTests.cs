using System;
using System.Linq;

namespace VblastSs.Tests
{
    /// <summary>The library computes in C# what it computes elsewhere.</summary>
    public static class SceneTests
    {
        internal static ulong HashOfAHangingThread()
        {
            using (var context = new Context())
            using (var scene = new Scene(context))
            using (var thread = new SutureThread(context, new ThreadConfig { SegmentCount = 20, Length = 0.1 }))
            {
                var pin = new ThreadAttachment { Kind = ThreadAttachmentKind.Pin, Node = 0 };
                thread.Attach(pin);
                scene.AddThread(thread);
                for (int i = 0; i < 50; i++)
                {
                    scene.Step(1e-3);
                }
                return scene.GetHash();
            }
        }

        public static void ADefaultOfTheLibraryIsTheDefaultOfAProperty()
        {
            var config = new ThreadConfig();
            Check.Equal(120u, config.SegmentCount, "segments");
            Check.Equal(new Vector3d(0, -9.81, 0), config.Gravity, "gravity");
            Check.Equal(Quaterniond.Identity, new SceneRigidConfig().Orientation, "orientation");
            Check.Equal(Method.Implicit, config.Method, "method");
        }

        public static void AThreadFallsAsFarAsGravitySays()
        {
            using (var context = new Context())
            using (var thread = new SutureThread(context, new ThreadConfig { SegmentCount = 10 }))
            {
                for (int i = 0; i < 100; i++)
                {
                    thread.Step(1e-3);
                }
                double height = thread.GetView(ThreadField.Positions).AsVectors()[0].Y;
                Check.That(Math.Abs(height + 0.5 * 9.81 * 0.01) < 1e-3, "fell to " + height);
            }
        }

        public static void ArraysOfAConfigurationReachTheLibrary()
        {
            using (var context = new Context())
            using (var thread = new SutureThread(context, new ThreadConfig { Positions = new[] { 0, 0, 0, 0.01, 0, 0, 0.02, 0.005, 0 } }))
            {
                View view = thread.GetView(ThreadField.Positions);
                Check.Equal(3, view.Count, "nodes");
                Check.Equal(new Vector3d(0.02, 0.005, 0), view.AsVectors()[2], "last node");
            }
        }

        public static void ArraysOfOneConfigurationAgreeOrAreRefused()
        {
            using (var context = new Context())
            {
                Check.Throws<ArgumentException>(() => new SutureThread(context, new ThreadConfig {
                    Positions = new double[9], RestLengths = new double[3] }));
                Check.Throws<ArgumentException>(() => new SutureThread(context, new ThreadConfig { Positions = new double[8] }));
            }
        }

        public static void ASavedStateGoesBackToTheSameHash()
        {
            using (var context = new Context())
            using (var scene = new Scene(context))
            using (var thread = new SutureThread(context))
            {
                scene.AddThread(thread);
                byte[] state = scene.Save();
                ulong before = scene.GetHash();
                scene.Step(1e-3);
                Check.That(before != scene.GetHash(), "a step changes the hash");
                scene.Restore(state);
                Check.Equal(before, scene.GetHash(), "hash");
            }
        }

        public static void ALoadedSceneHasItsBodiesAndOwnsThem()
        {
            byte[] state;
            ulong hash;
            using (var context = new Context())
            using (var scene = new Scene(context))
            using (var thread = new SutureThread(context))
            {
                scene.AddThread(thread);
                scene.Step(1e-3);
                state = scene.Save();
                hash = scene.GetHash();
                Check.That(ReferenceEquals(thread, scene.GetThread(1)), "the thread that was added is found");
            }
            using (var context = new Context())
            using (var scene = Scene.Load(context, state))
            {
                Check.Equal(hash, scene.GetHash(), "hash");
                Check.That(scene.GetBodies().SequenceEqual(new uint[] { 1 }), "bodies");
                scene.GetThread(1).Dispose(); // of the wrapper alone
                Check.Equal(121, scene.GetThread(1).GetView(ThreadField.Positions).Count, "nodes");
            }
        }

        public static void APoseGoesInAndComesOut()
        {
            using (var context = new Context())
            using (var scene = new Scene(context))
            {
                var config = new SceneRigidConfig { Position = new Vector3d(1, 2, 3), Orientation = new Quaterniond(0, 0, 1, 0),
                    Capsules = new[] { new SceneCapsule { Begin = new Vector3d(0, 0, 0), End = new Vector3d(0.01, 0, 0), Radius = 1e-3 } } };
                uint body = scene.AddRigid(config);
                SceneRigidState state = scene.GetRigid(body);
                Check.Equal(new Vector3d(1, 2, 3), state.Position, "position");
                Check.Equal(new Quaterniond(0, 0, 1, 0), state.Orientation, "orientation");
                scene.SetRigidTarget(body, new Vector3d(1, 2, 3.001), null);
                scene.Step(1e-3);
                Check.Equal(3.001, scene.GetRigid(body).Position.Z, "z");
                Check.Equal(new Quaterniond(0, 0, 1, 0), scene.GetRigid(body).Orientation, "orientation, which null keeps");
            }
        }

        public static void EventsComeOutInASpan()
        {
            using (var context = new Context())
            using (var scene = new Scene(context))
            using (var thread = new SutureThread(context, new ThreadConfig { SegmentCount = 10, Start = new Vector3d(0, 2e-3, 0) }))
            {
                scene.AddThread(thread);
                for (int i = 0; i < 60; i++)
                {
                    scene.Step(1e-3);
                }
                var events = new SceneEvent[16];
                ulong lost;
                int count = scene.TakeEvents(events, out lost);
                Check.That(count <= 16 && events.Take(count).All(one => one.Time > 0), "times");
            }
        }

        public static void ARecordedSceneReplaysToTheSameHash()
        {
            byte[] log;
            using (var context = new Context())
            using (var scene = new Scene(context))
            using (var thread = new SutureThread(context))
            {
                scene.AddThread(thread);
                using (var record = new Record(scene, new RecordConfig { Note = new byte[] { 1, 2, 3 } }))
                {
                    scene.SetRecorder(record);
                    for (int i = 0; i < 20; i++)
                    {
                        scene.Step(1e-3);
                    }
                    record.End();
                    log = record.Take();
                    scene.SetRecorder(null);
                }
            }
            using (var context = new Context())
            using (var replay = new Replay(context, log))
            {
                GC.Collect();
                byte[] note;
                string buildInfo;
                replay.GetInfo(out note, out buildInfo);
                Check.That(note.SequenceEqual(new byte[] { 1, 2, 3 }) && buildInfo == Vblast.BuildInfo(), "note and build");
                Scene scene = replay.LoadScene();
                ReplayReport report;
                int steps = 0;
                while ((report = replay.Step()).Outcome == ReplayOutcome.Stepped)
                {
                    steps++;
                }
                Check.Equal(20, steps, "steps");
                Check.Equal(20UL, report.AgreedStep, "agreed step");
                Check.Equal(ReplayOutcome.Ended, report.Outcome, "outcome");
                GC.KeepAlive(scene);
            }
        }

        public static void ArraysOfASignatureAreIndexedAndChecked()
        {
            var a = new Doubles6();
            var b = new Doubles6();
            a[3] = 1; // from the origin along x
            b[1] = b[4] = 0.5;
            b[2] = -1;
            b[5] = 1; // along z, 0.5 above the origin
            CollisionClosest closest = Collision.ClosestSegments(a, b);
            Check.Equal(0.5, closest.Distance, "distance");
            Check.Equal(new Vector3d(0, 0.5, 0), closest.PointB, "point");
            Check.Throws<IndexOutOfRangeException>(() => a[6] = 1);
        }
    }
}
