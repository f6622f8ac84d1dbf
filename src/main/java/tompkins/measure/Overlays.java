package tompkins.measure;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.EyeView;
import tompkins.light.StarCatalogue;
import tompkins.property.NumberText;
import tompkins.ray.Ray;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.IdentityTransformation;
import tompkins.spacetime.TransformationLaw;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.trace.Frame;
import tompkins.trace.RenderPlan;
import tompkins.world.FrameAppearance;

/**
 * Works out what is drawn over a picture, by formulas: for the centre of the lens, in the middle of the exposure, with
 * nothing in the way. It does not use the photograph, so that each checks the other. Wave fronts alone follow rays, to
 * the surfaces that are seen.
 */
public final class Overlays {

    /** Steps of a grid in degrees. */
    private static final double[] STEPS = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30};

    /** About how many circles of a grid are in the picture. */
    private static final int CIRCLES = 8;

    private static final double MERIDIAN = 15;

    /** A name has room inside what reaches farther from its middle than this part of the picture. */
    private static final double LARGE = 0.2;

    /** The angles of so many columns and rows say which circles are in the picture. */
    private static final int PLACES = 9;

    private static final double[] DOPPLER_FACTORS = {0.1, 0.2, 0.5, 0.8, 1, 1.25, 2, 5, 10};

    /** Half a turn, less what a meridian leaves out at its poles. */
    private static final double POLE = 1e-6;

    private static final double QUARTER = 90;

    private final Projection projection;
    private final SceneShapes shapes;
    private final RenderPlan plan;
    private final Studio studio;
    private final Studio measured;
    private final Map<FrameMotion, FrameAppearance> frames = new HashMap<>();
    private final FrameAppearance scene;

    /** Overlays of the picture of a projection, with the shapes of its scene and its plan. */
    public Overlays(Projection projection, SceneShapes shapes, RenderPlan plan) {
        this.projection = projection;
        this.shapes = shapes;
        this.plan = plan;
        studio = projection.studio();
        measured = studio.withView(View.MEASURED);
        scene = new FrameAppearance(studio, null);
    }

    /** One of them. */
    public OverlayDrawing draw(OverlayKind kind) {
        OverlayDrawing drawing =
                new OverlayDrawing(kind, new ArrayList<>(), new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        switch (kind) {
            case OUTLINES -> addOutlines(drawing, this::frame);
            case LINES -> addLines(drawing, this::frame);
            case AT_REST -> addGhost(drawing, motion -> FrameAppearance.atRest(studio, motion));
            case MEASURED -> addGhost(drawing, motion -> new FrameAppearance(measured, motion));
            case PLACES -> shapes.objects().forEach(thing -> addPositions(drawing, thing));
            case SCENE_GRID -> addGrid(drawing, Frame.SCENE);
            case CAMERA_GRID -> addGrid(drawing, Frame.CAMERA);
            case HORIZON -> addHorizon(drawing);
            case DOPPLER -> addDopplerFactors(drawing);
            case WAVE_FRONTS -> addWaveFronts(drawing);
            case LABELS -> shapes.objects().forEach(thing -> addName(drawing, thing));
            case STARS -> addStarNames(drawing);
        }
        return drawing;
    }

    private FrameAppearance frame(FrameMotion motion) {
        return frames.computeIfAbsent(motion, each -> new FrameAppearance(studio, each));
    }

    private void addGhost(OverlayDrawing drawing, Function<FrameMotion, FrameAppearance> seen) {
        Map<FrameMotion, FrameAppearance> known = new HashMap<>();
        Function<FrameMotion, FrameAppearance> once = motion -> known.computeIfAbsent(motion, seen);
        addOutlines(drawing, once);
        addLines(drawing, once);
    }

    private void addOutlines(OverlayDrawing drawing, Function<FrameMotion, FrameAppearance> seen) {
        shapes.spheres().forEach(ball -> addOutline(drawing, ball, seen.apply(ball.motion())));
    }

    private void addLines(OverlayDrawing drawing, Function<FrameMotion, FrameAppearance> seen) {
        shapes.lines().forEach(line -> addLine(drawing, line, seen.apply(line.motion())));
    }

    private void addOutline(OverlayDrawing drawing, SceneShapes.Ball ball, FrameAppearance frame) {
        addCurve(
                drawing,
                0,
                2 * Math.PI,
                azimuth -> projection.position(event -> {
                    LookCone outline =
                            LookCone.outline(frame.fromCamera(event).position(), ball.centre(), ball.radius());
                    return outline == null ? null : frame.look(outline.direction(azimuth));
                }));
    }

    private void addLine(OverlayDrawing drawing, SceneShapes.Line line, FrameAppearance frame) {
        addCurve(drawing, 0, 1, part -> {
            Vector3d point = line.places().apply(part);
            return line.turn() == null
                    ? projection.position(frame, point)
                    : projection.position(event -> look(frame, line.turn(), point, event));
        });
    }

    /** The direction in which a point that turns is seen from an event; null if it is not. */
    private static Vector3d look(FrameAppearance frame, SceneShapes.Turn turn, Vector3dc point, Event lens) {
        Vector3d middle = turn.foot(point);
        Event seen = frame.seen(time -> turn.place(point, time), middle, middle.distance(point), lens);
        return seen == null
                ? null
                : frame.look(seen.position().sub(frame.fromCamera(lens).position()));
    }

    private void addCurve(OverlayDrawing drawing, double from, double to, DoubleFunction<Vector2dc> curve) {
        drawing.lines().addAll(CurveTracer.lines(projection, from, to, curve));
    }

    private Vector2dc seen(SceneShapes.Thing thing) {
        Vector2dc position = projection.position(frame(thing.motion()), thing.middle());
        return isAround(thing) || !projection.shows(position) ? null : position;
    }

    /** Whether the lens is in the box around an object, for instance in a sky. */
    private boolean isAround(SceneShapes.Thing thing) {
        Event lens = frame(thing.motion()).fromCamera(projection.lensEvent());
        return thing.bounds().distance(lens.position()) == 0;
    }

    private void addPositions(OverlayDrawing drawing, SceneShapes.Thing thing) {
        if (isAround(thing)) {
            return;
        }
        Vector2dc seen = projection.position(frame(thing.motion()), thing.middle());
        Vector2dc now = projection.position(new FrameAppearance(measured, thing.motion()), thing.middle());
        if (projection.shows(seen)) {
            drawing.dots().add(seen);
        }
        if (projection.shows(now)) {
            drawing.rings().add(now);
        }
        if (seen != null && now != null && Math.abs(seen.x() - now.x()) < projection.columnsAround() / 2) {
            drawing.lines().add(List.of(seen, now));
        }
    }

    private void addName(OverlayDrawing drawing, SceneShapes.Thing thing) {
        Vector2dc position = seen(thing);
        if (position != null) {
            drawing.labels().add(new OverlayDrawing.Label(thing.name(), null, position, corners(thing, position)));
        }
    }

    /** The corners of a box around what is seen at a position; none if it takes much of the picture. */
    private List<Vector2dc> corners(SceneShapes.Thing thing, Vector2dc position) {
        double most =
                LARGE * Math.min(projection.view().width(), projection.view().height());
        List<Vector2dc> corners = new ArrayList<>();
        for (Vector3d corner : thing.bounds().corners()) {
            Vector2dc seen = projection.position(frame(thing.motion()), corner);
            if (seen == null || seen.distance(position) > most) {
                return List.of();
            }
            corners.add(seen);
        }
        return corners;
    }

    /** Those of the eye alone, in its own part of the picture. */
    private void addWaveFronts(OverlayDrawing drawing) {
        EyeView view = projection.view();
        Studio alone =
                studio.withCamera(view.camera()).withSettings(studio.settings().withSize(view.width(), view.height()));
        for (List<Vector2dc> line : WaveFronts.lines(RenderPlan.of(alone, plan))) {
            drawing.lines()
                    .add(line.stream()
                            .map(point -> (Vector2dc) point.add(view.column(), view.row(), new Vector2d()))
                            .toList());
        }
    }

    private void addStarNames(OverlayDrawing drawing) {
        if (!(studio.background() instanceof StarSky sky)) {
            return;
        }
        StarCatalogue.names().forEach((star, name) -> {
            Vector2dc position = position(Frame.SCENE, sky.direction(star));
            if (star.magnitude() <= sky.limit() && projection.shows(position)) {
                drawing.labels().add(new OverlayDrawing.Label(name, null, position));
            }
        });
    }

    private Vector3dc ahead() {
        return studio.velocity().direction();
    }

    /** The position at which a direction of a frame is seen, which is far away. */
    private Vector2dc position(Frame frame, Vector3dc direction) {
        return frame == Frame.CAMERA
                ? projection.position(direction)
                : projection.position(event -> scene.look(direction));
    }

    private void addCircle(OverlayDrawing drawing, Frame frame, double degrees) {
        LookCone circle =
                degrees == QUARTER ? LookCone.across(ahead()) : LookCone.around(ahead(), Math.toRadians(degrees));
        addCircle(drawing, frame, circle, NumberText.of(degrees), frame);
    }

    private void addCircle(OverlayDrawing drawing, Frame frame, LookCone circle, String text, Frame ofText) {
        List<List<Vector2dc>> lines =
                CurveTracer.lines(projection, 0, 2 * Math.PI, azimuth -> position(frame, circle.direction(azimuth)));
        drawing.lines().addAll(lines);
        Vector2dc label = nearestToMiddle(lines);
        if (label != null) {
            drawing.labels().add(new OverlayDrawing.Label(text, ofText, label));
        }
    }

    private Vector2dc nearestToMiddle(List<List<Vector2dc>> lines) {
        Vector2dc middle = projection.middle();
        return lines.stream()
                .flatMap(List::stream)
                .filter(projection::shows)
                .min((first, second) -> Double.compare(first.distance(middle), second.distance(middle)))
                .orElse(null);
    }

    private void addGrid(OverlayDrawing drawing, Frame frame) {
        DoubleSummaryStatistics angles = angles(frame);
        double step = DoubleStream.of(STEPS)
                .filter(each -> (angles.getMax() - angles.getMin()) / each <= CIRCLES)
                .findFirst()
                .orElse(STEPS[STEPS.length - 1]);
        double first = Math.max(1, Math.floor(angles.getMin() / step));
        for (double number = first; number * step < angles.getMax() + step; number++) {
            // as many digits as the step has
            double degrees = NumberText.rounded(number * step, 6);
            if (degrees < 180) {
                addCircle(drawing, frame, degrees);
            }
        }
        for (double turn = 0; turn < 360; turn += MERIDIAN) {
            double azimuth = Math.toRadians(turn);
            addCurve(
                    drawing,
                    POLE,
                    Math.PI - POLE,
                    angle -> position(frame, LookCone.around(ahead(), angle).direction(azimuth)));
        }
    }

    /** The angles to the motion at a few positions of the picture, in degrees. */
    private DoubleSummaryStatistics angles(Frame frame) {
        EyeView view = projection.view();
        return IntStream.range(0, PLACES * PLACES)
                .mapToDouble(i -> angle(
                        frame,
                        projection.direction(
                                view.column() + (double) view.width() * (i % PLACES) / (PLACES - 1),
                                view.row() + (double) view.height() * (i / PLACES) / (PLACES - 1))))
                .filter(Double::isFinite)
                .summaryStatistics();
    }

    private double angle(Frame frame, Vector3dc seen) {
        Ray ray = Ray.from(0, 0, 0, seen.x(), seen.y(), seen.z(), 0);
        Ray followed = frame == Frame.CAMERA ? ray : studio.sceneFromCamera().transform(ray);
        return Math.toDegrees(Angles.between(new Vector3d(followed.dx, followed.dy, followed.dz), ahead()));
    }

    /** The circles hold for what is at rest in the scene; everything else has its own Doppler factor. */
    private void addDopplerFactors(OverlayDrawing drawing) {
        if (studio.view() == View.MEASURED) {
            return;
        }
        if (!(studio.sceneFromCamera() instanceof IdentityTransformation)) {
            addDopplerCircles(drawing);
        }
        for (SceneShapes.Thing thing : shapes.objects()) {
            Vector2dc position = thing.motion() == null ? null : seen(thing);
            if (position != null) {
                double factor = frame(thing.motion()).dopplerFactor(projection.direction(position.x(), position.y()));
                drawing.labels()
                        .add(new OverlayDrawing.Label(dopplerFactor(NumberText.rounded(factor, 3)), null, position));
            }
        }
    }

    private static String dopplerFactor(double factor) {
        return "D = " + NumberText.of(factor);
    }

    /** Where the Doppler factor is a given number: cos a' = (1 - 1/(gamma D))/beta. */
    private void addDopplerCircles(OverlayDrawing drawing) {
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
                        dopplerFactor(factor),
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
