using System;
using System.Diagnostics;
using System.Threading;
using UnityEngine;
using VblastSs;

/// <summary>
/// Steps a hanging suture thread 1000 times a second on a thread of its own, and draws the newest state with the
/// LineRenderer of the same GameObject. The transform of the GameObject moves the end that is held.
/// </summary>
[RequireComponent(typeof(LineRenderer))]
public sealed class HangingThread : MonoBehaviour
{
    private const double StepLength = 1e-3; // s
    private const int MostStepsAtOnce = 10; // after a pause the simulation continues; it does not catch up

    private readonly object targetLock = new object();
    private Vector3d target;
    private Context context;
    private Scene scene;
    private SutureThread suture;
    private Replica replica;
    private uint held;
    private Thread stepper;
    private volatile bool stopping;
    private volatile Exception failure;
    private LineRenderer line;
    private Vector3[] points = new Vector3[0];

    private void OnEnable()
    {
        line = GetComponent<LineRenderer>();
        target = Frames.FromUnity(transform.position);
        failure = null;
        stopping = false;
        context = new Context(new ContextConfig { Log = (level, text) => UnityEngine.Debug.LogWarning(text) });
        scene = new Scene(context);
        suture = new SutureThread(context, new ThreadConfig { SegmentCount = 60, Length = 0.15, Start = target });
        held = suture.Attach(new ThreadAttachment { Kind = ThreadAttachmentKind.Pin, Node = 0, Position = target });
        scene.AddThread(suture);
        replica = new Replica(scene);
        replica.Publish(scene);
        stepper = new Thread(Run) { IsBackground = true, Name = "vblast_ss" };
        stepper.Start();
    }

    private void Update()
    {
        if (failure != null)
        {
            UnityEngine.Debug.LogException(failure);
            enabled = false;
            return;
        }
        lock (targetLock)
        {
            target = Frames.FromUnity(transform.position);
        }
        // Take and GetView of a replica are the calls that may run beside a step.
        if (replica.Take().IsNew == 0)
        {
            return;
        }
        ReadOnlySpan<Vector3d> nodes = replica.GetView(ReplicaField.Nodes).AsVectors();
        if (points.Length != nodes.Length)
        {
            points = new Vector3[nodes.Length];
            line.positionCount = nodes.Length;
        }
        for (int i = 0; i < nodes.Length; i++)
        {
            points[i] = Frames.ToUnity(nodes[i]);
        }
        line.SetPositions(points);
    }

    private void OnDisable()
    {
        stopping = true;
        if (stepper != null)
        {
            stepper.Join();
        }
        if (context != null)
        {
            context.Dispose(); // with everything in it
        }
    }

    private void Run()
    {
        try
        {
            Stopwatch watch = Stopwatch.StartNew();
            double done = 0;
            while (!stopping)
            {
                double now = watch.Elapsed.TotalSeconds;
                int steps = Math.Min(MostStepsAtOnce, (int)((now - done) / StepLength));
                for (int i = 0; i < steps; i++)
                {
                    Vector3d place;
                    lock (targetLock)
                    {
                        place = target;
                    }
                    suture.SetAttachmentTarget(held, place, null);
                    scene.Step(StepLength);
                }
                if (steps > 0)
                {
                    replica.Publish(scene);
                }
                done = steps == MostStepsAtOnce ? now : done + steps * StepLength;
                Thread.Sleep(1);
            }
        }
        catch (Exception exception)
        {
            failure = exception;
        }
    }
}
