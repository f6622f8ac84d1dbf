package tompkins.lab;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3dc;
import tompkins.file.FileException;
import tompkins.image.LinearImage;
import tompkins.image.PhotographFile;
import tompkins.image.PictureFormat;
import tompkins.io.Assignment;
import tompkins.io.Assignments;
import tompkins.io.FactJson;
import tompkins.io.SelfDescription;
import tompkins.io.StudioReader;
import tompkins.measure.MeasureKind;
import tompkins.measure.Measured;
import tompkins.measure.Measurements;
import tompkins.measure.Projection;
import tompkins.measure.RayHistory;
import tompkins.measure.Sighting;
import tompkins.property.InvalidPropertyException;
import tompkins.property.MistakeException;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.world.FrameAppearance;

/**
 * The program as a library. Studios are immutable: {@link #read} one, and make others {@link #with} other values.
 *
 * <p>Pixels are those of the command line: column and row from 0 at the upper left, where whole numbers are centres.
 * Points are in the scene frame, lengths in scene units, angles in radians, c = 1. A mistake of the caller, in a scene,
 * a value or the name of a file, is a {@link MistakeException} with the message of the command line.
 *
 * <p>A lab keeps the trees of the last studio for the next, as long as only the camera changes, so that a sweep builds
 * them once. One lab is for one thread at a time; several may work at once.
 */
public final class Lab implements AutoCloseable {

    private final Renderer renderer;
    private RenderPlan last;

    /** A lab that renders with one thread for each core. */
    public Lab() {
        this(Runtime.getRuntime().availableProcessors());
    }

    /**
     * A lab that renders with a number of threads.
     *
     * @throws IllegalArgumentException if it is below 1
     */
    public Lab(int threads) {
        renderer = new Renderer(threads);
    }

    /** The studio of a scene file, or of a saved photograph. */
    public static Studio read(Path file) {
        return StudioReader.read(file);
    }

    /** The studio of the text of a scene file; its pictures and meshes are in a folder. */
    public static Studio read(String text, Path folder) {
        return StudioReader.read(text, "text", folder);
    }

    /**
     * The studio with another value, as by {@code --set}.
     *
     * @param path the way to a key, such as {@code velocity.beta} or {@code scene[0].radius}
     * @param value a number, or a text that is written as in a scene file
     */
    public static Studio with(Studio studio, String path, Object value) {
        return Assignments.applyTo(studio, List.of(new Assignment("with", path, String.valueOf(value))), Path.of(""));
    }

    /**
     * Takes the picture, as large and as good as the studio says.
     *
     * @return its light, linear, row after row from the top
     */
    public LinearImage picture(Studio studio) {
        return taken(studio).image();
    }

    /**
     * Takes the photograph and saves it with the scene inside. A file of the name is not replaced: the photograph gets
     * a number then.
     *
     * @param file the ending of its name says the format, such as {@code .png} or {@code .tif}
     * @return where it is
     */
    public Path photograph(Studio studio, Path file) {
        try {
            PictureFormat format = PictureFormat.of(file);
            PhotographFile.requireWritable(file);
            return PhotographFile.write(
                    file, picture(studio), format, studio.settings().toneCurve(), SelfDescription.of(studio), false);
        } catch (FileException failure) {
            throw new MistakeException(failure.getMessage());
        }
    }

    /** The ray of a pixel, through the centre of the lens, in the middle of the exposure, and all that it meets. */
    public Sighting ray(Studio studio, double column, double row) {
        return Sighting.of(planned(studio), column + 0.5, row + 0.5);
    }

    /** What {@code trace --json} prints of a ray. */
    public static String json(Sighting ray) {
        return FactJson.values(RayHistory.of(ray));
    }

    /** What {@code measure --json} prints. */
    public static String json(Measured measured) {
        return FactJson.measured(measured.facts());
    }

    /**
     * Where the picture shows a point that rests in the scene, for the centre of the lens, in the middle of the
     * exposure, with nothing before the lens. Something may stand in front of the point.
     *
     * @return column and row; empty if the point lies outside of the picture
     */
    public static Optional<Vector2dc> pixel(Studio studio, Vector3dc point) {
        Projection projection = Projection.of(studio);
        return Optional.ofNullable(projection.position(new FrameAppearance(studio, null), point))
                .filter(projection::shows)
                .map(position -> new Vector2d(position).sub(0.5, 0.5));
    }

    /**
     * The angle between the directions, in the camera frame, in which two points are seen that rest in the scene. Both
     * may lie outside of the picture.
     *
     * @return in radians, 0 to pi; empty if a lens cannot see one of them because it lies behind
     */
    public static OptionalDouble angle(Studio studio, Vector3dc first, Vector3dc second) {
        Projection projection = Projection.of(studio);
        FrameAppearance scene = new FrameAppearance(studio, null);
        Vector2dc one = projection.position(scene, first);
        Vector2dc other = projection.position(scene, second);
        return one == null || other == null
                ? OptionalDouble.empty()
                : OptionalDouble.of(
                        projection.direction(one.x(), one.y()).angle(projection.direction(other.x(), other.y())));
    }

    /**
     * Measures between pixels.
     *
     * @param kind {@code between}, {@code profile}, {@code circle} or {@code line}
     * @param pixels column and row of each pixel, one after the other
     */
    public Measured measure(Studio studio, String kind, double... pixels) {
        MeasureKind wanted = MeasureKind.named(kind)
                .orElseThrow(() -> new MistakeException("kind must be one of "
                        + Arrays.stream(MeasureKind.values())
                                .map(MeasureKind::toString)
                                .collect(Collectors.joining(", "))
                        + ", was " + kind));
        int count = pixels.length / 2;
        if (pixels.length % 2 != 0 || count < wanted.fewest() || count > wanted.most()) {
            throw new MistakeException(wanted + " needs the columns and rows of " + wanted.fewest()
                    + (wanted.most() == wanted.fewest() ? "" : " or more") + " pixels, was " + pixels.length
                    + " numbers");
        }
        List<Vector2dc> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            points.add(point(studio, pixels[2 * i], pixels[2 * i + 1]));
        }
        try {
            return Measurements.measure(planned(studio), wanted, points, () -> true);
        } catch (ArithmeticException noFit) {
            throw new MistakeException("pixels: " + noFit.getMessage());
        }
    }

    /** Ends the threads of the lab. */
    @Override
    public void close() {
        renderer.close();
    }

    private static Vector2dc point(Studio studio, double column, double row) {
        double right = studio.settings().width() - 0.5;
        double bottom = studio.settings().height() - 0.5;
        if (!(column >= -0.5 && row >= -0.5 && column <= right && row <= bottom)) {
            throw new MistakeException("pixels must lie in the picture, from -0.5,-0.5 to " + right + "," + bottom
                    + ", was " + column + "," + row);
        }
        return new Vector2d(column + 0.5, row + 0.5);
    }

    private RenderPlan planned(Studio studio) {
        try {
            last = RenderPlan.of(studio, last);
            return last;
        } catch (InvalidPropertyException refused) {
            throw new MistakeException(refused.getMessage());
        }
    }

    private RenderJob taken(Studio studio) {
        Quality quality = Quality.of(studio);
        Renderer.requireMemory(studio.settings(), quality);
        RenderJob job = renderer.start(planned(studio), quality, RenderListener.NONE);
        try {
            job.await();
        } catch (InterruptedException stopped) {
            job.cancel();
            Thread.currentThread().interrupt();
            throw new MistakeException("the picture was interrupted");
        }
        return job;
    }
}
