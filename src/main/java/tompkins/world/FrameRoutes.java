package tompkins.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.spacetime.Event;

/**
 * The ways between the frames of a world, as changes of frame one after the other: nested motions are never made into
 * one boost, because two boosts are a boost and a rotation. Immutable.
 */
public final class FrameRoutes {

    private final FrameStep[][][] routes;
    private final FrameStep cameraToScene;

    FrameRoutes(List<InertialFrame> frames, FrameCrossing crossing) {
        cameraToScene = crossing.step();
        int count = frames.size();
        List<List<InertialFrame>> chains =
                frames.stream().map(FrameRoutes::chain).toList();
        routes = new FrameStep[count][count][];
        for (int from = 0; from < count; from++) {
            for (int to = 0; to < count; to++) {
                routes[from][to] = route(chains.get(from), chains.get(to), crossing);
            }
        }
    }

    /** The frames from the outermost to this one. */
    private static List<InertialFrame> chain(InertialFrame frame) {
        List<InertialFrame> chain = new ArrayList<>();
        for (InertialFrame each = frame; each != null; each = each.outer()) {
            chain.add(each);
        }
        Collections.reverse(chain);
        return chain;
    }

    private static FrameStep[] route(List<InertialFrame> from, List<InertialFrame> to, FrameCrossing crossing) {
        int shared = 0;
        while (shared < Math.min(from.size(), to.size()) && from.get(shared) == to.get(shared)) {
            shared++;
        }
        List<FrameStep> steps = new ArrayList<>();
        for (int i = from.size() - 1; i >= shared; i--) {
            steps.add(stepInto(from.get(i), crossing).inverse());
        }
        for (int i = shared; i < to.size(); i++) {
            steps.add(stepInto(to.get(i), crossing));
        }
        return steps.toArray(FrameStep[]::new);
    }

    private static FrameStep stepInto(InertialFrame frame, FrameCrossing crossing) {
        return crossing.stepInto(frame.motion(), frame.outer().origin(), frame.origin());
    }

    /** Makes {@code memory}, which may be the ray itself, the same ray in another frame, where it starts on nothing. */
    public Ray transform(int from, int to, Ray ray, Ray memory) {
        memory.set(ray);
        for (FrameStep step : routes[from][to]) {
            step.transform(memory, memory);
        }
        return memory;
    }

    /** Takes each ray of a packet into another frame. */
    void transform(int from, int to, RayPacket rays) {
        for (FrameStep step : routes[from][to]) {
            step.transform(rays);
        }
    }

    /** The same event in another frame, in the coordinates in which the tracer works. */
    public Event transform(int from, int to, Event event) {
        Event moved = event;
        for (FrameStep step : routes[from][to]) {
            moved = step.transform(moved);
        }
        return moved;
    }

    /** Makes {@code memory} the ray of a frame in the camera frame. */
    Ray toCamera(int from, Ray ray, Ray memory) {
        transform(from, 0, ray, memory);
        return cameraToScene.inverse().transform(memory, memory);
    }

    /** Makes {@code memory} the ray of the camera frame in another. */
    Ray fromCamera(int to, Ray ray, Ray memory) {
        cameraToScene.transform(ray, memory);
        return transform(0, to, memory, memory);
    }
}
