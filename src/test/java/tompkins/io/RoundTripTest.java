package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.TestRun;
import tompkins.camera.Camera;
import tompkins.camera.ThinLensCamera;
import tompkins.image.LinearImage;
import tompkins.image.PhotographFile;
import tompkins.image.PhotographInfo;
import tompkins.image.PictureFile;
import tompkins.image.PictureFormat;
import tompkins.image.ToneCurve;
import tompkins.lesson.Lesson;
import tompkins.lesson.LessonNumber;
import tompkins.lesson.LessonPlan;
import tompkins.lesson.Measurement;
import tompkins.lesson.MeasuringPoint;
import tompkins.lesson.RayReading;
import tompkins.lesson.RayValue;
import tompkins.light.Flash;
import tompkins.light.LightSource;
import tompkins.light.PointLight;
import tompkins.property.Descriptions;
import tompkins.ray.PixelPicture;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.Shutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.Background;
import tompkins.studio.Lighting;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.surface.PictureSurface;
import tompkins.surface.Surface;

/** What is written is read back equal, to the last bit, for every type that a scene file can name. */
class RoundTripTest {

    private static final int INSTANCES = TestRun.cases(5, 40);

    @TempDir
    private Path folder;

    private List<PixelPicture> pictures;

    @BeforeEach
    void makePictures() throws IOException {
        Files.createDirectory(folder.resolve("pictures"));
        pictures = List.of(picture("one.png", 3, 2), picture("pictures/two \u03b2.png", 1, 5));
    }

    private PixelPicture picture(String name, int width, int height) throws IOException {
        Path file = folder.resolve(name);
        LinearImage image = new LinearImage(width, height, new float[3 * width * height]);
        PhotographFile.write(file, image, PictureFormat.PNG, ToneCurve.LINEAR, PhotographInfo.NONE, true);
        return PictureFile.read(Files.readAllBytes(file), name);
    }

    static Stream<Class<?>> types() {
        return Stream.concat(
                Families.ALL.stream().flatMap(family -> Descriptions.members(family).stream()),
                Stream.of(RenderSettings.class, Studio.class));
    }

    @ParameterizedTest
    @MethodSource("types")
    void defaultAndRandomInstancesAreReadBack(Class<?> type) {
        assertReadBack(studioWith(Descriptions.standard(type)));
        RandomDescriptions random = new RandomDescriptions(type.getSimpleName().hashCode(), pictures);
        Set<Object> different = new HashSet<>();
        for (int i = 0; i < INSTANCES; i++) {
            Object description = random.record(type);
            Object other = random.record(type);
            assertThat(Descriptions.areEqual(description, other)).isEqualTo(description.equals(other));
            assertThat(Descriptions.areEqual(description, Descriptions.changed(description, (name, value) -> value)))
                    .isTrue();
            different.add(description);
            assertReadBack(studioWith(description));
        }
        assertThat(different).hasSizeGreaterThan(type.getRecordComponents().length == 0 ? 0 : 1);
    }

    private void assertReadBack(Studio studio) {
        String named = StudioWriter.write(studio);
        assertThat(StudioReader.read(named, "named", folder)).as(named).isEqualTo(studio);
        String selfContained = StudioWriter.writeSelfContained(studio);
        Path elsewhere = folder.resolve("pictures");
        assertThat(StudioReader.read(selfContained, "self-contained", elsewhere))
                .as(selfContained)
                .isEqualTo(studio);
        assertThat(StudioWriter.write(StudioReader.read(named, "again", folder)))
                .isEqualTo(named);
    }

    /** A studio in which a description has a place. */
    private static Studio studioWith(Object description) {
        Studio studio = Studio.DEFAULT;
        if (description instanceof SceneObject object) {
            Studio inScene = studio.withScene(List.of(object));
            boolean moves = object.moves();
            return moves ? inScene : inScene.withCameraFrame(List.of(Sphere.DEFAULT, object));
        }
        if (description instanceof Surface surface) {
            return studio.withScene(List.of(new Sphere("", new Vector3d(), 1, surface)));
        }
        if (description instanceof LightSource light) {
            return Lighting.of(studio, List.of(light));
        }
        if (description instanceof Shutter shutter) {
            return studio.withCamera(ThinLensCamera.DEFAULT.withShutter(shutter));
        }
        if (description instanceof Camera camera) {
            return studio.withCamera(camera);
        }
        if (description instanceof LessonPlan lesson) {
            return Descriptions.with(studio, "lesson", lesson);
        }
        if (description instanceof Measurement measurement) {
            LessonNumber number = Descriptions.with(LessonNumber.DEFAULT, "measurement", measurement);
            return studioWith(Descriptions.with(Lesson.DEFAULT, "numbers", List.of(number)));
        }
        if (description instanceof MeasuringPoint point) {
            return studioWith(new RayReading(point, RayValue.X));
        }
        if (description instanceof Flash flash) {
            return studioWith(Descriptions.with(PointLight.DEFAULT, "flash", flash));
        }
        if (description instanceof RenderSettings settings) {
            return studio.withSettings(settings);
        }
        return description instanceof Background background
                ? Descriptions.with(studio, "background", background)
                : (Studio) description;
    }

    @Test
    void extremeNumbersKeepTheirBits() {
        double[] numbers = {
            0.1 + 0.2,
            Double.MIN_VALUE,
            Double.MAX_VALUE,
            Double.MIN_NORMAL,
            -0.0,
            1e9,
            1e22,
            123456789012345680.0,
            5e-324,
            Math.nextUp(1.0),
            Math.PI,
            2e-3,
            9007199254740993.0,
            1e23
        };
        for (double number : numbers) {
            Sphere sphere = new Sphere("sphere", new Vector3d(number, 0, 0), 1, ColouredSurface.DEFAULT);
            Studio studio = Studio.DEFAULT.withScene(List.of(sphere));
            Sphere read = (Sphere) StudioReader.read(StudioWriter.write(studio), "", folder)
                    .scene()
                    .get(0);
            double back = read.centre().x();
            assertThat(Double.doubleToRawLongBits(back)).isEqualTo(Double.doubleToRawLongBits(number));
        }
    }

    @Test
    void writtenFileIsReadable() {
        Sphere ball = new Sphere("ball", new Vector3d(0, 1.5, 10), 2, ColouredSurface.DEFAULT);
        Studio studio = Studio.DEFAULT
                .withScene(List.of(ball))
                .withVelocity(Velocity.of(0, 0, 0.99))
                .withSettings(RenderSettings.DEFAULT.withSamples(16));
        assertThat(StudioWriter.write(studio)).isEqualTo("""
                {
                  "version": 1,
                  "scene": [{"type": "Sphere", "description": "ball", "centre": [0, 1.5, 10], "radius": 2}],
                  "velocity": [0, 0, 0.99],
                  "settings": {"samples": 16}
                }
                """);
    }

    @Test
    void savedFileNamesPicturesBesideItAndHoldsTheOthers() throws IOException {
        Studio studio = Studio.DEFAULT.withScene(List.of(
                new Sphere("", new Vector3d(), 1, new PictureSurface(pictures.get(0), true, true)),
                new Sphere("", new Vector3d(), 2, new PictureSurface(pictures.get(1), true, true))));
        Path here = folder.resolve("scene.json");
        StudioWriter.save(studio, here, true);
        assertThat(Files.readString(here)).isEqualTo(StudioWriter.write(studio));
        assertThat(StudioReader.read(here)).isEqualTo(studio);

        Path other = Files.createDirectory(folder.resolve("other"));
        Files.write(other.resolve("one.png"), pictures.get(0).file());
        StudioWriter.save(studio, other.resolve("scene.json"), true);
        assertThat(Files.readString(other.resolve("scene.json")))
                .contains("\"picture\": \"one.png\"")
                .contains("base64");
        assertThat(StudioReader.read(other.resolve("scene.json"))).isEqualTo(studio);
    }

    /**
     * Four characters of a photograph's text for three bytes of a picture: two of six million fit into 16 million,
     * three do not.
     */
    @Test
    void photographOnlyNamesPicturesThatAreTooManyForIt() {
        Studio tooMuch = Studio.DEFAULT.withScene(List.of(
                poster("large.png", 7_000_000), poster("small.png", 1_000_000), poster("medium.png", 6_000_000)));
        Studio enough = Studio.DEFAULT.withScene(
                List.of(poster("large.png", 6_000_000), poster("small.png", 100_000), poster("medium.png", 6_000_000)));

        assertThat(StudioWriter.filesOnlyNamed(tooMuch)).containsExactly("large.png", "small.png", "medium.png");
        assertThat(StudioWriter.writeSelfContained(tooMuch))
                .hasSizeLessThan(1000)
                .contains("\"picture\": \"small.png\"");
        assertThat(StudioWriter.filesOnlyNamed(enough)).isEmpty();
        String whole = StudioWriter.writeSelfContained(enough);
        assertThat(whole.length()).isBetween(12_100_000 / 3 * 4, PhotographInfo.LONGEST_SCENE);
        assertThat(new PhotographInfo("", "", whole).sceneJson()).isEqualTo(whole);
    }

    /** One picture on three objects travels three times. */
    @Test
    void photographNamesAPictureThatIsUsedTooOften() {
        Sphere poster = poster("poster.png", 5_000_000);

        assertThat(StudioWriter.filesOnlyNamed(Studio.DEFAULT.withScene(List.of(poster, poster))))
                .isEmpty();
        Studio thrice = Studio.DEFAULT.withScene(List.of(poster, poster, poster));
        assertThat(StudioWriter.filesOnlyNamed(thrice)).containsExactly("poster.png");
        assertThat(StudioWriter.writeSelfContained(thrice)).hasSizeLessThan(1000);
    }

    private static Sphere poster(String name, int bytes) {
        PixelPicture picture = new PixelPicture(name, 1, 1, new float[4], new byte[bytes]);
        return new Sphere(name, new Vector3d(), 1, new PictureSurface(picture, true, true));
    }

    @Test
    void photographHoldsItsScene() throws IOException {
        Studio studio = Studio.DEFAULT.withScene(
                List.of(new Sphere("\u03b2", new Vector3d(), 1, new PictureSurface(pictures.get(1), true, true))));
        LinearImage image = new LinearImage(1, 1, new float[3]);
        for (PictureFormat format : PictureFormat.values()) {
            Path file = folder.resolve("pictures/photograph" + format.endings().get(0));
            PhotographInfo info = new PhotographInfo("", "", StudioWriter.writeSelfContained(studio));
            PhotographFile.write(file, image, format, ToneCurve.LINEAR, info, true);
            assertThat(StudioReader.read(file)).isEqualTo(studio);
            Path renamed = Files.move(file, folder.resolve("renamed.json"));
            assertThat(StudioReader.read(renamed)).isEqualTo(studio);
            Files.delete(renamed);
        }
    }
}
