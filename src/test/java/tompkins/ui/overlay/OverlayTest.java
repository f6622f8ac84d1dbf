package tompkins.ui.overlay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.camera.Stereo;
import tompkins.camera.StereoLayout;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.measure.OverlayKind;
import tompkins.measure.Sketch;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.LensEvent;
import tompkins.studio.Lighting;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Mirror;
import tompkins.trace.RenderPlan;
import tompkins.ui.LightLook;
import tompkins.ui.measure.MeasureMarks;
import tompkins.ui.model.Settings;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Asker;
import tompkins.ui.picture.Overlay;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.picture.Pictures;

/** What is drawn over pictures lies where it should. */
@LightLook
class OverlayTest {

    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;

    /** Lines are written above and below it. */
    private static final Rectangle WHOLE = new Rectangle(WIDTH, HEIGHT);

    private static final Rectangle FREE = new Rectangle(0, 30, WIDTH, HEIGHT - 60);

    private static BufferedImage painted(Overlay overlay, Studio studio) {
        return painted(overlay, studio, new Rectangle(WIDTH, HEIGHT));
    }

    private static BufferedImage painted(Overlay overlay, Studio studio, Rectangle free) {
        Studio large = studio.withSettings(studio.settings().withSize(WIDTH, HEIGHT));
        return painted(overlay, Pictures.black(large), free);
    }

    private static BufferedImage painted(Overlay overlay, Picture picture, Rectangle free) {
        BufferedImage canvas = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = canvas.createGraphics();
        g.setColor(Color.GRAY);
        g.fillRect(0, 0, WIDTH, HEIGHT);
        overlay.paint(g, picture, new Rectangle(WIDTH, HEIGHT), new Rectangle(WIDTH, HEIGHT), free);
        g.dispose();
        return canvas;
    }

    /** The rectangle around what was painted. */
    private static Rectangle marked(BufferedImage canvas) {
        return Pictures.around(WIDTH, HEIGHT, i -> isMarked(canvas, i));
    }

    private static int brightPixels(Vector2dc point) {
        MeasureMarks marks = new MeasureMarks(() -> null);
        marks.show(
                List.of(new MeasureMarks.Marked(new Sketch(List.of(point), List.of()), List.of("the name"))),
                List.of());
        BufferedImage canvas = painted(marks, Studio.DEFAULT);
        return (int) IntStream.range(0, WIDTH * HEIGHT)
                .filter(i -> isMarked(canvas, i))
                .count();
    }

    /** The ball has a radius of 50 pixels in the middle, or fills much of the picture. */
    @Test
    void aNameStandsBesideASmallThing() {
        for (double radius : new double[] {50, 300}) {
            Studio studio =
                    Studios.sphere().withSettings(Studio.DEFAULT.settings().withSize(WIDTH, HEIGHT));
            double slope = Math.tan(Math.toRadians(10)) * radius / (WIDTH / 2.0);
            BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
            SceneOverlay.paint(
                    image,
                    studio.withScene(List.of(new Sphere(
                            "ball", new Vector3d(0, 0, 10), 10 * Math.sin(Math.atan(slope)), LuminousSurface.DEFAULT))),
                    Set.of(OverlayKind.LABELS));
            Rectangle written = box(image);
            assertThat(written.isEmpty()).isFalse();
            boolean covers = IntStream.range(0, written.width)
                    .anyMatch(
                            column -> Point2D.distance(written.x + column, written.getMaxY(), WIDTH / 2.0, HEIGHT / 2.0)
                                    < radius);
            assertThat(covers).isEqualTo(radius > 100);
            assertThat(written.getCenterX()).isCloseTo(WIDTH / 2.0, within(radius));
        }
    }

    /** Around all that is not black. */
    private static Rectangle box(BufferedImage image) {
        return Pictures.around(WIDTH, HEIGHT, i -> (image.getRGB(i % WIDTH, i / WIDTH) & 0xffffff) != 0);
    }

    @Test
    void aNameAtTheUpperEdgeIsWhole() {
        int inTheMiddle = brightPixels(new Vector2d(WIDTH / 2.0, HEIGHT / 2.0));
        assertThat(brightPixels(new Vector2d(WIDTH / 2.0, 10))).isBetween(inTheMiddle - 5, inTheMiddle + 5);
    }

    private static VelocityArrow arrow() {
        VelocityArrow arrow = new VelocityArrow();
        arrow.setShown(true);
        return arrow;
    }

    private static Studio flying(double x, double y, double z) {
        return Studios.sphere().withVelocity(Velocity.of(x, y, z));
    }

    @Test
    void ringLiesWhereTheCameraFlies() {
        // a tenth to the right of the view: 0.1/tan(10 degrees) of half the width
        Rectangle ring = marked(painted(arrow(), flying(0.05, 0, 0.5)));
        int x = (int) Math.round(320 + 320 * 0.1 / Math.tan(Math.toRadians(10)));
        assertThat(ring.x).isBetween(x - 14, x - 9);
        assertThat(ring.y).isBetween(240 - 14, 240 - 9);
        Rectangle tail = marked(painted(arrow(), flying(-0.05, 0, -0.5)));
        assertThat(tail).as("ring around the tail, and other words").isNotEqualTo(ring);
        assertThat(tail.getLocation()).as("and no arrow").isEqualTo(ring.getLocation());
    }

    /** Whoever looks straight back sees where the camera comes from; what is measured there has its name above. */
    @Test
    void theMarksOfTheFlightLeaveRoomForANameAbove() {
        BufferedImage tail = painted(arrow(), flying(0, 0, -0.5));
        MeasureMarks marks = new MeasureMarks(() -> null);
        marks.show(
                List.of(new MeasureMarks.Marked(
                        new Sketch(List.of(new Vector2d(320, 240)), List.of()), List.of("the name"))),
                List.of());
        BufferedImage name = painted(marks, Studio.DEFAULT);
        // the words, to the right of ring and cross
        assertThat(IntStream.range(0, WIDTH * HEIGHT)
                        .filter(i -> i % WIDTH > 320 + 14 && isMarked(tail, i) && isMarked(name, i))
                        .count())
                .isZero();
    }

    /** In an anaglyph both eyes see a ring, 9 pixels apart: twice the words would be illegible. */
    @Test
    void ringsSideBySideShareTheirWords() {
        Studio one = flying(0, 0, 0.5);
        Stereo eyes = new Stereo(StereoLayout.ANAGLYPH, 0.05, 10);
        BufferedImage both = painted(arrow(), one.withCamera(Descriptions.with(one.camera(), "stereo", eyes)));
        assertThat(marked(both).x).as("the left ring").isLessThan(marked(painted(arrow(), one)).x);
        // 38 more if both had words; these lie half a pixel further
        assertThat(belowTheRing(both)).isCloseTo(belowTheRing(painted(arrow(), one)), within(10L));
    }

    private static long belowTheRing(BufferedImage canvas) {
        return IntStream.range((240 + 13) * WIDTH, HEIGHT * WIDTH)
                .filter(i -> isMarked(canvas, i))
                .count();
    }

    private static boolean isMarked(BufferedImage canvas, int pixel) {
        return canvas.getRGB(pixel % WIDTH, pixel / WIDTH) != Color.GRAY.getRGB();
    }

    @Test
    void wordsAtTheRightEdgeAreWhole() {
        Rectangle inside = marked(painted(arrow(), flying(0.05, 0, 0.5)));
        // the view is 20 degrees wide: the ring lies 12 pixels from the edge
        double edge = 308 / 320.0 * Math.tan(Math.toRadians(10));
        Rectangle beside = marked(painted(arrow(), flying(0.5 * edge, 0, 0.5)));
        assertThat(beside.width).isBetween(inside.width - 4, inside.width + 4);
    }

    private static Asker asker() {
        return new Asker("test", error -> {
            throw new AssertionError(error);
        });
    }

    private static SceneOverlay overlay(OverlayKind... kinds) {
        SceneOverlay overlay = new SceneOverlay(() -> {}, asker());
        overlay.setShown(Set.of(kinds));
        return overlay;
    }

    @Test
    void whatMayNotAgreeWithThePictureIsSaid() {
        Studio fine = flying(0, 0, 0.8);
        Studio wide = fine.withCamera(Descriptions.with(fine.camera(), "apertureRadius", 0.2));
        Studio window = fine.withCameraFrame(List.of(new Sphere("", new Vector3d(0, 0, -5), 1, Mirror.DEFAULT)));

        Stereo eyes = new Stereo(StereoLayout.TOP_AND_BOTTOM, 0.3, 10);
        Studio pair = wide.withCamera(Descriptions.with(wide.camera(), "stereo", eyes));

        // the line at the bottom, far from the sphere
        assertThat(lowest(fine, WHOLE)).isLessThan(HEIGHT - 100);
        for (Studio told : List.of(wide, window, pair)) {
            assertThat(lowest(told, WHOLE)).isGreaterThan(HEIGHT - 30);
            assertThat(lowest(told, FREE)).as("above captions").isBetween(HEIGHT - 60.0, HEIGHT - 30.0);
        }
    }

    private static double lowest(Studio studio, Rectangle free) {
        return marked(painted(overlay(OverlayKind.OUTLINES), studio, free)).getMaxY();
    }

    /** At 0.8 c straight ahead tan(a'/2) is a third of tan(a/2). */
    @Test
    void outlineLiesAroundTheSphere() {
        Rectangle outline = marked(painted(overlay(OverlayKind.OUTLINES), flying(0, 0, 0.8)));
        double angle = 2 * Math.atan(Math.tan(Math.asin(0.1) / 2) / 3);
        double radius = 320 * Math.tan(angle) / Math.tan(Math.toRadians(10));

        assertThat(outline.getCenterX()).isCloseTo(320, within(1.0));
        assertThat(outline.getCenterY()).isCloseTo(240, within(1.0));
        assertThat(outline.width / 2.0).isBetween(radius + 1, radius + 4);
        assertThat(marked(painted(overlay(), flying(0, 0, 0.8))).isEmpty()).isTrue();
    }

    /** A shutter that opens at many times is worked out by another thread; then the canvas is painted again. */
    @Test
    void slowOverlaysComeLater() throws InterruptedException {
        Studio fine = flying(0, 0, 0.8);
        assertComesLater(
                fine.withCamera(fine.camera().withShutter(DetectorPlaneShutter.DEFAULT)), OverlayKind.OUTLINES);
    }

    /** Only where a lamp flashes do wave fronts need rays, and another thread. */
    @Test
    void waveFrontsComeLater() throws InterruptedException {
        Studio dark = Studios.sphere();
        assertThat(marked(painted(overlay(OverlayKind.OUTLINES, OverlayKind.WAVE_FRONTS), dark))
                        .isEmpty())
                .isFalse();
        PointLight lamp = new PointLight(new Vector3d(), Colour.WHITE, Colour.BLACK, 1, new Pulse(0, 1, 0));
        assertComesLater(Lighting.of(dark, List.of(lamp)), OverlayKind.OUTLINES, OverlayKind.WAVE_FRONTS);
    }

    private static void assertComesLater(Studio studio, OverlayKind... kinds) throws InterruptedException {
        CountDownLatch again = new CountDownLatch(1);
        SceneOverlay overlay = new SceneOverlay(again::countDown, asker());
        overlay.setShown(Set.of(kinds));
        Picture picture = Pictures.black(studio.withSettings(studio.settings().withSize(WIDTH, HEIGHT)));
        assertThat(marked(painted(overlay, picture, FREE)).isEmpty()).isTrue();
        assertThat(again.await(5, TimeUnit.MINUTES)).isTrue();
        assertThat(marked(painted(overlay, picture, FREE)).isEmpty()).isFalse();
    }

    @Test
    void nothingIsDrawnAtRestOrIfItIsNotWanted() {
        assertThat(marked(painted(arrow(), Studios.sphere())).isEmpty()).isTrue();
        assertThat(marked(painted(new VelocityArrow(), flying(0, 0, 0.5))).isEmpty())
                .isTrue();
        assertThat(marked(painted(new SceneMap(), flying(0, 0, 0.5))).isEmpty()).isTrue();
    }

    private static SceneMap map(MapAxis axis) {
        SceneMap map = new SceneMap();
        map.setShown(Optional.of(axis));
        return map;
    }

    @Test
    void theMapLeavesRoomForWhatIsWritten() {
        assertThat(FREE.contains(marked(painted(map(MapAxis.SIDE), Studios.sphere(), FREE))))
                .isTrue();
    }

    /** The sphere lies in front of the camera: to the right of the lens, which is white, or above it. */
    @Test
    void mapShowsTheSceneAlongEachAxis() {
        Rectangle place = marked(painted(map(MapAxis.SIDE), Studios.sphere()));
        assertThat(place.getMaxX()).isBetween(620.0, 640.0);
        assertThat(place.getMaxY()).isBetween(460.0, 480.0);
        assertThat(lens(MapAxis.SIDE).x).isBetween(place.x, place.x + place.width / 3);
        assertThat(lens(MapAxis.ABOVE).y).isBetween(place.y + place.height * 2 / 3, place.y + place.height);
        Rectangle middle =
                new Rectangle(place.x + place.width / 3, place.y + place.height / 3, place.width / 3, place.height / 3);
        assertThat(middle.contains(lens(MapAxis.BEHIND))).isTrue();
    }

    private static Point lens(MapAxis axis) {
        BufferedImage canvas = painted(map(axis), Studios.sphere());
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                if (canvas.getRGB(x, y) == Color.WHITE.getRGB()) {
                    return new Point(x, y);
                }
            }
        }
        throw new AssertionError("no lens on the map");
    }

    /**
     * A box flies along x at 0.8 c and is right ahead at a distance d when the picture is taken. Its light left at the
     * time -t with t² = d² + (0.8 t)², so that its place was -4/3 d aside.
     */
    @Test
    void mapShowsWhereMovingObjectsAreAndWereSeen() {
        double half = 1e-9;
        Box from = Descriptions.with(Box.DEFAULT, "from", new Vector3d(-half, -half, 6 - half));
        Box box = Descriptions.with(from, "to", new Vector3d(half, half, 6 + half));
        double time = LensEvent.inScene(Studios.sphere()).time();
        SceneObject moving = new Moving("", Velocity.of(0.8, 0, 0), new Vector3d(-0.8 * time, 0, 0), 0, List.of(box));
        Studio studio = Studios.sphere().withScene(List.of(moving));
        MappedBoxes boxes = new MappedBoxes(RenderPlan.of(studio), MapAxis.ABOVE);

        Rectangle2D now = boxes.now().getBounds2D();
        Rectangle2D seen = boxes.seen().getBounds2D();

        assertThat(now.getCenterX()).isCloseTo(0, within(1e-6));
        assertThat(now.getCenterY()).isCloseTo(6, within(1e-6));
        assertThat(seen.getCenterX() - now.getCenterX()).isCloseTo(-8, within(1e-6));
        assertThat(seen.getCenterY()).isCloseTo(6, within(1e-6));
        assertThat(boxes.isStill()).isFalse();
        assertThat(new MappedBoxes(RenderPlan.of(Studios.sphere()), MapAxis.ABOVE).isStill())
                .isTrue();
    }

    /** What belongs to a scene goes with it; the arrow belongs to whoever looks. */
    @Test
    void anotherSceneHasNoOverlaysAndNoMap() {
        StudioModel model = new StudioModel(Studios.sphere(), null);
        PictureOverlays overlays =
                new PictureOverlays(model, new PictureCanvas(room -> {}), new Settings((Path) null), asker());
        overlays.setShown(OverlayKind.OUTLINES, true);
        overlays.setMap(Optional.of(MapAxis.SIDE));
        model.set(Studios.lattice());
        assertThat(overlays.ofScene()).containsExactly(OverlayKind.OUTLINES);
        assertThat(overlays.map()).contains(MapAxis.SIDE);
        model.open(Studios.sphere(), null);
        assertThat(overlays.ofScene()).isEmpty();
        assertThat(overlays.isShown(OverlayKind.OUTLINES)).isFalse();
        assertThat(overlays.map()).isEmpty();
        assertThat(overlays.isArrowShown()).isTrue();
    }
}
