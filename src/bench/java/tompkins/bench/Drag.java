package tompkins.bench;

import com.sun.management.GarbageCollectionNotificationInfo;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import javax.management.NotificationEmitter;
import javax.management.NotificationListener;
import javax.management.openmbean.CompositeData;
import org.joml.Vector3d;
import tompkins.render.Renderer;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** What dragging the speed costs the tracer: a picture after the other, each at another speed, without a window. */
final class Drag {

    private Drag() {}

    /** Drags for some seconds. */
    static void measure(int seconds, List<Measure> measures) throws InterruptedException {
        AtomicLong longest = new AtomicLong();
        NotificationListener listener = (notification, handback) -> {
            GarbageCollectionNotificationInfo info =
                    GarbageCollectionNotificationInfo.from((CompositeData) notification.getUserData());
            longest.accumulateAndGet(info.getGcInfo().getDuration(), Math::max);
        };
        for (GarbageCollectorMXBean collector : ManagementFactory.getGarbageCollectorMXBeans()) {
            ((NotificationEmitter) collector).addNotificationListener(listener, null, null);
        }
        Studio studio = PaperStudios.fig1b();
        int pictures = 0;
        long start = System.nanoTime();
        try (Renderer renderer = new Renderer()) {
            RenderPlan plan = RenderPlan.of(studio);
            while (System.nanoTime() - start < seconds * 1_000_000_000L) {
                double beta = 0.9 + 0.09 * Math.sin(pictures / 50.0);
                plan = RenderPlan.of(
                        studio.withVelocity(Velocity.of(SpeedScale.BETA, beta, new Vector3d(0.2, -0.1, 0.97))), plan);
                renderer.render(plan);
                pictures++;
            }
        }
        double taken = (System.nanoTime() - start) / 1e9;
        measures.add(Measure.noticedAtLeast(
                "pictures a second while the speed changes, without window", 30, "", pictures / taken));
        measures.add(Measure.noticedAtMost(
                "longest pause of the garbage collector in " + seconds + " s of that", 10, "ms", longest.get()));
    }
}
