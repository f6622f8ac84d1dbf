package tompkins.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.SamplePositions;
import tompkins.primitive.Described;
import tompkins.primitive.Primitive;
import tompkins.primitive.RestFrame;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.LightInMedium;
import tompkins.spacetime.MomentaryRestFrame;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.surface.Surface;

/**
 * The history of one sample: where and when its ray starts in both frames, what it hits, and the colour that comes
 * back.
 *
 * @param cameraStart the event at which the ray starts, in the camera frame
 * @param cameraDirection unit direction in which it is traced, in the camera frame
 * @param sceneStart the event at which its main branch enters the scene frame, or null if it never does; where a ray
 *     splits, the main branch goes on with most of the light
 * @param sceneDirection unit direction in the scene frame, or null
 * @param sceneDopplerFactor frequency of the light that the camera sees divided by that in the scene frame; 1 without
 *     crossing, and no number where the scene is measured without light
 * @param sceneDirectionLength length, in the scene frame, of the direction that has length 1 in the camera frame: the
 *     scene is brighter to the camera by the inverse of its fourth power, which in vacuum is that of the ratio of the
 *     frequencies
 * @param hits everything that was hit, in the order of tracing: where a ray splits, first all of its weaker branch; of
 *     the main branch the first {@link #MOST_HITS} and the last, and as many of all weaker ones
 * @param hitsLeftOut how many hits there were beside these
 * @param lastDirection unit direction in the scene frame in which the main branch goes on after all hits and meets
 *     nothing more, or null if it ends at its last hit
 * @param lastSlowness slowness of light in the scene frame on that last way; 1 if there is none
 * @param lastDopplerFactor frequency of the light that the camera sees divided by that in the scene frame on that last
 *     way, behind all mirrors; no number if there is none
 * @param segments the straight pieces of all branches in the scene frame, in the order of tracing
 * @param overtaken the light in the same direction of the camera that the camera overtakes, in the rest frame of the
 *     medium around it, if it is faster than light there; the ray is that of light that it meets. Null if there is none
 * @param colour the colour of the sample, before exposure
 */
public record SampleHistory(
        Event cameraStart,
        Vector3dc cameraDirection,
        Event sceneStart,
        Vector3dc sceneDirection,
        double sceneDopplerFactor,
        double sceneDirectionLength,
        List<Encounter> hits,
        long hitsLeftOut,
        Vector3dc lastDirection,
        double lastSlowness,
        double lastDopplerFactor,
        List<Segment> segments,
        LightInMedium.Seen overtaken,
        Colour colour) {

    /** So many hits of the main branch are kept, and of weaker branches; mirrors may send a ray round for ever. */
    public static final int MOST_HITS = 10_000;

    private static final int FEW_HITS = 100;

    /**
     * A straight piece of a ray in the scene frame.
     *
     * @param start the event at which the ray enters the scene, or the hit from which it goes on
     * @param hit the hit at which it ends; null if it meets nothing more
     * @param direction unit direction if it meets nothing more; null if it ends at a hit
     * @param branch 0 on the main branch, 1 on a weaker one that left it, 2 on a weaker one of that, and so on
     */
    public record Segment(Event start, Encounter hit, Vector3dc direction, int branch) {}

    /**
     * One hit.
     *
     * @param object the object, as the scene file describes it
     * @param frame the frame of place, time and distance
     * @param event where and when
     * @param distance distance from the start of the ray that hit, in that frame
     * @param fraction the largest fraction of the sample's light that the ray that hit can still bring
     * @param branch 0 on the main branch, 1 on a weaker one that left it, 2 on a weaker one of that, and so on
     * @param surface the surface
     * @param rest the same hit in the frame in which the object rests
     * @param flashes what each flash lamp of the scene does there
     */
    public record Encounter(
            Described object,
            Frame frame,
            Event event,
            double distance,
            double fraction,
            int branch,
            Surface surface,
            Rest rest,
            List<FlashSight> flashes) {

        /** Whether the object moves by itself, so that it rests in a frame of its own. */
        public boolean movesByItself() {
            return rest.motion() != null || rest.velocity() != null;
        }

        /** Where and when in the scene frame. */
        public Event inScene(SpaceTimeTransformation sceneFromCamera) {
            return frame == Frame.SCENE ? event : sceneFromCamera.transform(event);
        }

        /** Where and when in the camera frame. */
        public Event inCamera(SpaceTimeTransformation sceneFromCamera) {
            return frame == Frame.CAMERA ? event : sceneFromCamera.inverse().transform(event);
        }
    }

    /**
     * A hit in the frame in which the object rests and is described; on an object that turns, in the one in which the
     * point that is hit rests for a moment.
     *
     * @param motion how that frame moves in the scene; null if the object rests in the frame of the hit
     * @param event where, and at what proper time of the object; of what turns, where the point is described
     * @param clockReading what a clock of the object shows there
     * @param dopplerFactor frequency in the camera frame divided by that in this frame; no number if there is none
     * @param normal unit normal of the surface, out of the object or to the side named as front, along the axes of this
     *     frame
     * @param velocity with which the point runs that is hit, in the frame in which its axis rests; null if it does not
     *     turn
     * @param u first coordinate on the surface, as the object runs it; no number where the surface has no use for it
     * @param v second coordinate; no number where the surface has no use for it
     */
    public record Rest(
            FrameMotion motion,
            Event event,
            double clockReading,
            double dopplerFactor,
            Vector3dc normal,
            Vector3dc velocity,
            double u,
            double v) {}

    /** Whether the main branch goes on after all hits, and meets nothing more. */
    public boolean reachesBackground() {
        return lastDirection != null;
    }

    /** The hit at which the main branch ends, or null if it meets nothing, or goes on after all hits. */
    public Encounter end() {
        List<Encounter> main = mainHits();
        return main.isEmpty() || reachesBackground() ? null : main.get(main.size() - 1);
    }

    /**
     * The frequency that the camera sees divided by that with which the light was sent out: in the rest frame of the
     * object at the end of the main branch, or in the scene frame if that is the background. No number if no light
     * comes.
     */
    public double dopplerFactor() {
        return end() == null ? lastDopplerFactor : end().rest().dopplerFactor();
    }

    /** What the main branch hit, in the order of tracing. */
    public List<Encounter> mainHits() {
        return hits.stream().filter(hit -> hit.branch == 0).toList();
    }

    /** Follows one sample in the middle of the exposure time; null if it never crosses the shutter. */
    public static SampleHistory of(RenderPlan plan, double x, double y, double lensX, double lensY) {
        return of(plan, x, y, lensX, lensY, SamplePositions.MIDDLE);
    }

    /**
     * Follows one sample.
     *
     * @param x place in the picture in pixels; the centre of pixel (i, j) is (i + 1/2, j + 1/2)
     * @param y place in the picture in pixels
     * @param lensX place on the lens in units of its radius
     * @param lensY place on the lens in units of its radius
     * @param moment the part of the exposure time that has passed, from 0 to 1
     * @return its history, or null if the sample never crosses the shutter and so has none
     */
    public static SampleHistory of(RenderPlan plan, double x, double y, double lensX, double lensY, double moment) {
        return of(plan, x, y, lensX, lensY, moment, Long.MAX_VALUE);
    }

    /**
     * Follows a sample through the centre of the lens in the middle of the exposure time, for somebody who asks for the
     * way of the light and not for its colour: weaker branches are followed for few hits, and the colour lacks the
     * light of what is left out. Null if it never crosses the shutter.
     */
    public static SampleHistory way(RenderPlan plan, double x, double y) {
        return of(plan, x, y, 0, 0, SamplePositions.MIDDLE, FEW_HITS);
    }

    /** What rays meet in the middle of the exposure that are spread over a picture, so many in each row and column. */
    public static Stream<Encounter> hits(RenderPlan plan, int side) {
        return SamplePositions.spread(plan.width(), plan.height(), side)
                .map(place -> way(plan, place.x(), place.y()))
                .filter(history -> history != null)
                .flatMap(history -> history.hits().stream());
    }

    private static SampleHistory of(
            RenderPlan plan, double x, double y, double lensX, double lensY, double moment, long mostWeaker) {
        Recorder recorder = new Recorder(plan, mostWeaker);
        Colour colour = plan.tracer(new RayCounts(), recorder).sample(x, y, lensX, lensY, moment);
        return recorder.startDirection == null ? null : recorder.history(colour);
    }

    private static final class Recorder implements PathObserver {

        private final RenderPlan plan;

        /** After so many hits of weaker branches these are no longer followed. */
        private final long mostWeaker;

        private final FlashWatch flashes;
        private final List<Encounter> hits = new ArrayList<>();
        private long mainHits;
        private long weakerHits;

        /** The latest hit of the main branch, if that is not kept for being one of too many; or null. */
        private Encounter latest;

        private final List<Segment> segments = new ArrayList<>();

        /** The hits at which the weaker branches begin that are being followed. */
        private final List<Event> forks = new ArrayList<>();

        /** Where the present piece of the ray begins in the scene frame; null in the camera frame. */
        private Event corner;

        private int cameraFrame;
        private Event start;
        private Vector3d startDirection;
        private Event crossing;
        private Vector3d crossingDirection;
        private double sceneDopplerFactor = 1;
        private double sceneDirectionLength = 1;
        private Vector3d lastDirection;
        private double lastSlowness = 1;
        private double lastDopplerFactor = Double.NaN;
        private int branch;

        Recorder(RenderPlan plan, long mostWeaker) {
            this.plan = plan;
            this.mostWeaker = mostWeaker;
            flashes = plan.flashWatch();
        }

        @Override
        public void branches() {
            branch++;
            forks.add(corner);
        }

        @Override
        public boolean hasSeenEnough() {
            return branch > 0 && weakerHits >= mostWeaker;
        }

        @Override
        public void returns() {
            branch--;
            corner = forks.remove(branch);
        }

        @Override
        public void starts(Ray ray) {
            cameraFrame = ray.frame;
            start = start(ray);
            startDirection = new Vector3d(ray.dx, ray.dy, ray.dz);
        }

        @Override
        public void crosses(Ray ray) {
            corner = plan.inScene(0, start(ray));
            if (branch == 0) {
                crossing = corner;
                crossingDirection = new Vector3d(ray.dx, ray.dy, ray.dz);
                sceneDopplerFactor = ratio(ray);
                sceneDirectionLength = ray.directionLength;
            }
        }

        @Override
        public void hits(Hit hit) {
            Frame frame = frame(hit.frame);
            Ray ray = hit.ray;
            Primitive primitive = (Primitive) hit.boundary;
            boolean isKept = (branch == 0 ? mainHits++ : weakerHits++) < MOST_HITS;
            if (!isKept && branch > 0) {
                return;
            }
            Event traced = new Event(hit.x, hit.y, hit.z, hit.time);
            RestFrame rest = primitive.restFrame();
            MomentaryRestFrame point =
                    hit.pointMoves ? new MomentaryRestFrame(hit, rest.rotation().law()) : null;
            Hit event = hit.event == null ? hit : hit.event;
            Event met = frame == Frame.CAMERA
                    ? traced
                    : plan.inScene(event.frame, new Event(event.x, event.y, event.z, event.time));
            Encounter encounter = new Encounter(
                    primitive.object(),
                    frame,
                    met,
                    frame == Frame.CAMERA || ray.frame == 0
                            ? hit.distance
                            : distance(plan.inScene(ray.frame, start(ray)), met),
                    ray.throughput,
                    branch,
                    primitive.surface(),
                    new Rest(
                            rest.motion(),
                            rest.own(traced),
                            hit.clockReading(),
                            ratio(point == null ? ray : point.enter(ray)),
                            point == null ? new Vector3d(hit.normalX, hit.normalY, hit.normalZ) : point.normal(),
                            point == null ? null : new Vector3d(hit.velocityX, hit.velocityY, hit.velocityZ),
                            hit.coordinates == null ? Double.NaN : hit.coordinates.u(),
                            hit.coordinates == null ? Double.NaN : hit.coordinates.v()),
                    flashes == null ? List.of() : flashes.at(hit));
            if (isKept) {
                hits.add(encounter);
            } else {
                latest = encounter;
            }
            if (frame == Frame.SCENE) {
                if (isKept) {
                    segments.add(new Segment(corner, encounter, null, branch));
                }
                corner = met;
            }
        }

        private Frame frame(int number) {
            return number == cameraFrame ? Frame.CAMERA : Frame.SCENE;
        }

        private static Event start(Ray ray) {
            return new Event(ray.x, ray.y, ray.z, ray.time);
        }

        private static double distance(Event from, Event to) {
            return from.position().distance(to.position());
        }

        /** Frequency in the camera frame divided by that in the frame of a ray. */
        private static double ratio(Ray ray) {
            return ray.measures ? Double.NaN : 1 / ray.frequency;
        }

        @Override
        public void leaves(Ray ray) {
            if (frame(ray.frame) == Frame.CAMERA || branch > 0 && weakerHits > MOST_HITS) {
                return;
            }
            Vector3d direction = new Vector3d(ray.dx, ray.dy, ray.dz);
            segments.add(new Segment(corner, null, direction, branch));
            if (branch == 0) {
                lastDirection = direction;
                lastSlowness = ray.slowness;
                lastDopplerFactor = ratio(ray);
            }
        }

        SampleHistory history(Colour colour) {
            if (latest != null) {
                hits.add(latest);
            }
            return new SampleHistory(
                    start,
                    startDirection,
                    crossing,
                    crossingDirection,
                    sceneDopplerFactor,
                    sceneDirectionLength,
                    List.copyOf(hits),
                    mainHits + weakerHits - hits.size(),
                    lastDirection,
                    lastSlowness,
                    lastDopplerFactor,
                    List.copyOf(segments),
                    plan.overtaken(startDirection),
                    colour);
        }
    }
}
