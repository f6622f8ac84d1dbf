package tompkins.measure;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.NumberText;
import tompkins.ray.Ray;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.IdentityTransformation;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.TransformationLaw;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.trace.Frame;

/**
 * Works out what is drawn over a picture, by formulas: for the centre of the lens, in the middle of the exposure, with
 * nothing in the way. It does not use the photograph, so that each checks the other.
 */
public final class Overlays {

    /** Steps of a grid in degrees. */
    private static final double[] STEPS = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30};

    /** About how many circles of a grid are in the picture. */
    private static final int CIRCLES = 8;

    private static final double MERIDIAN = 15;

    private static final double[] DOPPLER_FACTORS = {0.1, 0.2, 0.5, 0.8, 1, 1.25, 2, 5, 10};

    /** Half a turn, less what a meridian leaves out at its poles. */
    private static final double POLE = 1e-6;

    private static final double QUARTER = 90;

    private final Projection projection;
    private final SceneShapes shapes;
    private final Studio studio;
    private final Map<FrameMotion, SeenFrame> frames = new HashMap<>();
    private final SeenFrame scene;

    /** Overlays of the picture of a projection, with the shapes of its scene. */
    public Overlays(Projection projection, SceneShapes shapes) {
        this.projection = projection;
        this.shapes = shapes;
        studio = projection.studio();
        scene = new SeenFrame(studio, null);
    }

    /** One of them. */
    public OverlayDrawing draw(OverlayKind kind) {
        OverlayDrawing drawing =
                new OverlayDrawing(kind, new ArrayList<>(), new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        switch (kind) {
            case OUTLINES -> addOutlines(drawing, this::frame);
            case LINES -> addLines(drawing, this::frame);
            case AT_REST -> addGhost(drawing, motion -> SeenFrame.atRest(studio, motion));
            case MEASURED -> addGhost(drawing, motion -> new SeenFrame(studio, motion, View.MEASURED));
            case PLACES -> shapes.objects().forEach(thing -> addPlaces(drawing, thing));
            case SCENE_GRID -> addGrid(drawing, Frame.SCENE);
            case CAMERA_GRID -> addGrid(drawing, Frame.CAMERA);
            case HORIZON -> addHorizon(drawing);
            case DOPPLER -> addDopplerCircles(drawing);
            case LABELS -> shapes.objects().forEach(thing -> addName(drawing, thing));
        }
        return drawing;
    }

    private SeenFrame frame(FrameMotion motion) {
        return frames.computeIfAbsent(motion, each -> new SeenFrame(studio, each));
    }

    private void addGhost(OverlayDrawing drawing, Function<FrameMotion, SeenFrame> seen) {
        Map<FrameMotion, SeenFrame> known = new HashMap<>();
        Function<FrameMotion, SeenFrame> once = motion -> known.computeIfAbsent(motion, seen);
        addOutlines(drawing, once);
        addLines(drawing, once);
    }

    private void addOutlines(OverlayDrawing drawing, Function<FrameMotion, SeenFrame> seen) {
        shapes.spheres().forEach(ball -> addOutline(drawing, ball, seen.apply(ball.motion())));
    }

    private void addLines(OverlayDrawing drawing, Function<FrameMotion, SeenFrame> seen) {
        shapes.lines().forEach(line -> addLine(drawing, line, seen.apply(line.motion())));
    }

    private void addOutline(OverlayDrawing drawing, SceneShapes.Ball ball, SeenFrame frame) {
        drawing.lines()
                .addAll(CurveTracer.lines(
                        projection,
                        0,
                        2 * Math.PI,
                        azimuth -> projection.place(event -> {
                            LookCone outline =
                                    LookCone.outline(frame.fromCamera(event).position(), ball.centre(), ball.radius());
                            return outline == null ? null : frame.look(outline.direction(azimuth));
                        })));
    }

    private void addLine(OverlayDrawing drawing, SceneShapes.Line line, SeenFrame frame) {
        drawing.lines()
                .addAll(CurveTracer.lines(
                        projection,
                        0,
                        1,
                        share -> projection.place(frame, line.start().lerp(line.end(), share, new Vector3d()))));
    }

    private Vector2dc seen(SceneShapes.Thing thing) {
        return isAround(thing) ? null : inPicture(projection.place(frame(thing.motion()), thing.middle()));
    }

    /** Whether the lens is in the box around an object, for instance in a sky. */
    private boolean isAround(SceneShapes.Thing thing) {
        Event lens = frame(thing.motion()).fromCamera(projection.lensEvent());
        return thing.bounds().distance(lens.position()) == 0;
    }

    private Vector2dc inPicture(Vector2dc place) {
        return place != null
                        && place.x() >= 0
                        && place.y() >= 0
                        && place.x() <= projection.width()
                        && place.y() <= projection.height()
                ? place
                : null;
    }

    private void addPlaces(OverlayDrawing drawing, SceneShapes.Thing thing) {
        if (isAround(thing)) {
            return;
        }
        Vector2dc seen = projection.place(frame(thing.motion()), thing.middle());
        Vector2dc now = projection.place(new SeenFrame(studio, thing.motion(), View.MEASURED), thing.middle());
        if (inPicture(seen) != null) {
            drawing.dots().add(seen);
        }
        if (inPicture(now) != null) {
            drawing.rings().add(now);
        }
        if (seen != null && now != null && Math.abs(seen.x() - now.x()) < projection.columnsAround() / 2) {
            drawing.lines().add(List.of(seen, now));
        }
    }

    private void addName(OverlayDrawing drawing, SceneShapes.Thing thing) {
        Vector2dc place = seen(thing);
        if (place != null) {
            drawing.labels().add(new OverlayDrawing.Label(thing.name(), null, place));
        }
    }

    private Vector3dc ahead() {
        return studio.velocity().direction();
    }

    /** The place at which a direction of a frame is seen, which is far away. */
    private Vector2dc place(Frame frame, Vector3dc direction) {
        return frame == Frame.CAMERA ? projection.place(direction) : projection.place(event -> scene.look(direction));
    }

    private void addCircle(OverlayDrawing drawing, Frame frame, double degrees) {
        LookCone circle =
                degrees == QUARTER ? LookCone.across(ahead()) : LookCone.around(ahead(), Math.toRadians(degrees));
        addCircle(drawing, frame, circle, NumberText.of(degrees), frame);
    }

    private void addCircle(OverlayDrawing drawing, Frame frame, LookCone circle, String text, Frame ofText) {
        List<List<Vector2dc>> lines =
                CurveTracer.lines(projection, 0, 2 * Math.PI, azimuth -> place(frame, circle.direction(azimuth)));
        drawing.lines().addAll(lines);
        Vector2dc label = nearestToMiddle(lines);
        if (label != null) {
            drawing.labels().add(new OverlayDrawing.Label(text, ofText, label));
        }
    }

    private Vector2dc nearestToMiddle(List<List<Vector2dc>> lines) {
        Vector2d middle = new Vector2d(projection.width() / 2.0, projection.height() / 2.0);
        return lines.stream()
                .flatMap(List::stream)
                .filter(place -> inPicture(place) != null)
                .min((first, second) -> Double.compare(first.distance(middle), second.distance(middle)))
                .orElse(null);
    }

    private void addGrid(OverlayDrawing drawing, Frame frame) {
        double step = step(frame);
        double[] range = range(frame);
        for (double number = Math.max(1, Math.floor(range[0] / step)); number * step < range[1] + step; number++) {
            // as many digits as the step has
            double degrees = NumberText.rounded(number * step, 6);
            if (degrees < 180) {
                addCircle(drawing, frame, degrees);
            }
        }
        for (double turn = 0; turn < 360; turn += MERIDIAN) {
            double azimuth = Math.toRadians(turn);
            Vector3d across = LookCone.across(ahead()).direction(azimuth);
            drawing.lines()
                    .addAll(CurveTracer.lines(
                            projection,
                            POLE,
                            Math.PI - POLE,
                            angle -> place(
                                    frame,
                                    new Vector3d(ahead()).mul(Math.cos(angle)).fma(Math.sin(angle), across))));
        }
    }

    /** The step of a grid at which a few circles are in the picture. */
    private double step(Frame frame) {
        double[] range = range(frame);
        for (double step : STEPS) {
            if ((range[1] - range[0]) / step <= CIRCLES) {
                return step;
            }
        }
        return STEPS[STEPS.length - 1];
    }

    /** The least and the largest angle to the motion at a few places of the picture, in degrees. */
    private double[] range(Frame frame) {
        double least = 180;
        double largest = 0;
        SpaceTimeTransformation sceneFromCamera = studio.sceneFromCamera();
        int parts = 8;
        for (int i = 0; i <= parts * parts + 2 * parts; i++) {
            double x = (double) projection.width() * (i % (parts + 1)) / parts;
            double y = (double) projection.height() * (i / (parts + 1)) / parts;
            Vector3dc seen = projection.direction(x, y);
            Ray ray = Ray.from(0, 0, 0, seen.x(), seen.y(), seen.z(), 0);
            Ray followed = frame == Frame.CAMERA ? ray : sceneFromCamera.transform(ray);
            double degrees =
                    Math.toDegrees(Angles.between(new Vector3d(followed.dx, followed.dy, followed.dz), ahead()));
            if (!Double.isNaN(degrees)) {
                least = Math.min(least, degrees);
                largest = Math.max(largest, degrees);
            }
        }
        return new double[] {least, largest};
    }

    /** Where the frequency for the camera is that of the scene, times a number: cos a' = (1 - 1/(gamma D))/beta. */
    private void addDopplerCircles(OverlayDrawing drawing) {
        if (studio.sceneFromCamera() instanceof IdentityTransformation || studio.view() == View.MEASURED) {
            return;
        }
        double speed = studio.velocity().speed();
        // in a Galilean world no clock runs slow
        double gamma = studio.transformation() == TransformationLaw.LORENTZ
                ? studio.velocity().gamma()
                : 1;
        for (double factor : DOPPLER_FACTORS) {
            double cosine = (1 - 1 / (gamma * factor)) / speed;
            if (Math.abs(cosine) < 1) {
                addCircle(
                        drawing,
                        Frame.CAMERA,
                        LookCone.around(ahead(), Math.acos(cosine)),
                        "D = " + NumberText.of(factor),
                        null);
            }
        }
    }

    private void addHorizon(OverlayDrawing drawing) {
        if (!studio.velocity().isRest()) {
            addCircle(drawing, Frame.SCENE, QUARTER);
            addCircle(drawing, Frame.CAMERA, QUARTER);
        }
    }
}
