package tompkins.lab;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.measure.Measured;
import tompkins.measure.Quantity;
import tompkins.measure.Sighting;
import tompkins.property.MistakeException;
import tompkins.studio.Studio;

/** What programs of other people ask a {@link Lab}. */
class LabTest {

    @AutoClose
    private static final Lab LAB = new Lab(2);

    /** A ball ahead of a pinhole that looks along its motion. */
    private static final String BALL = """
            {"velocity": [0, 0, 0.6], "settings": {"width": 80, "height": 60},
             "camera": {"horizontalAngleDegrees": 90, "shutter": {"type": "AperturePlaneShutter"}},
             "lights": [{"type": "AmbientLight"}],
             "scene": [{"type": "Sphere", "centre": [0, 0, 8], "radius": 1, "description": "ball"}]}""";

    @TempDir
    private Path folder;

    private static Studio ball() {
        return Lab.read(BALL, Path.of(""));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 0.6, 0.99})
    void anglesShrinkByAberration(double beta) {
        Studio studio = Lab.with(ball(), "velocity.beta", beta);
        double half = Math.atan2(3, 8);

        double angle =
                Lab.angle(studio, new Vector3d(3, 0, 8), new Vector3d(-3, 0, 8)).orElseThrow();

        // tan(a'/2) = sqrt((1 - b)/(1 + b)) tan(a/2), for each half
        double expected = 4 * Math.atan(Math.sqrt((1 - beta) / (1 + beta)) * Math.tan(half / 2));
        assertThat(angle).isCloseTo(expected, within(1e-12));
    }

    @Test
    void pixelsAreThoseOfTheCommandLine() {
        Studio rest = Lab.with(ball(), "velocity.beta", 0);

        Vector2dc pixel = Lab.pixel(rest, new Vector3d(2, 1, 8)).orElseThrow();

        // 90 degrees over 80 columns: a slope of 1 is 40 pixels; whole numbers are centres
        assertThat(pixel.x()).isCloseTo(40 + 40 * 2 / 8.0 - 0.5, within(1e-9));
        assertThat(pixel.y()).isCloseTo(30 - 40 * 1 / 8.0 - 0.5, within(1e-9));
        assertThat(Lab.pixel(rest, new Vector3d(9, 0, 8))).isEmpty();
        assertThat(Lab.pixel(rest, new Vector3d(0, 0, -8))).isEmpty();
        assertThat(Lab.angle(rest, new Vector3d(0, 0, -8), new Vector3d(0, 0, 8)))
                .isEmpty();
    }

    @Test
    void rayOfAPixelMeetsWhatIsThere() {
        Sighting ray = LAB.ray(ball(), 39.5, 29.5);

        assertThat(ray.hit().object().description()).isEqualTo("ball");
        assertThat(ray.inScene().position().distance(0, 0, 7)).isLessThan(1e-12);
        assertThat(ray.dopplerFactor()).isCloseTo(2, within(1e-12));
        assertThat(Lab.json(ray)).contains("\"object\": \"ball\"");
    }

    @Test
    void measuresBetweenPixels() {
        Measured measured = LAB.measure(Lab.with(ball(), "velocity.beta", 0), "between", 39.5, 29.5, 49.5, 29.5);

        double angle = measured.quantities()
                .filter(each -> each.key().equals("cameraAngle"))
                .mapToDouble(Quantity::value)
                .findFirst()
                .orElseThrow();
        assertThat(angle).isCloseTo(Math.toDegrees(Math.atan(0.25)), within(1e-9));
        assertThat(Lab.json(measured)).contains("cameraAngle");
    }

    @Test
    void sweepIsAsSinglePictures() {
        List<Studio> speeds = Stream.of(0.1, 0.5, 0.9)
                .map(beta -> Lab.with(ball(), "velocity.beta", beta))
                .toList();

        for (Studio studio : speeds) {
            try (Lab other = new Lab(1)) {
                assertThat(LAB.picture(studio).rgb())
                        .isEqualTo(other.picture(studio).rgb());
            }
        }
    }

    @Test
    void twoLabsWorkAtOnce() {
        List<CompletableFuture<float[]>> pictures = Stream.of(0.2, 0.8)
                .map(beta -> CompletableFuture.supplyAsync(() -> {
                    try (Lab lab = new Lab(1)) {
                        Studio studio = Lab.with(ball(), "velocity.beta", beta);
                        lab.ray(studio, 1, 1);
                        return lab.picture(studio).rgb();
                    }
                }))
                .toList();

        assertThat(pictures.get(0).join())
                .isEqualTo(LAB.picture(Lab.with(ball(), "velocity.beta", 0.2)).rgb());
        assertThat(pictures.get(1).join())
                .isEqualTo(LAB.picture(Lab.with(ball(), "velocity.beta", 0.8)).rgb());
    }

    @Test
    void photographHoldsItsScene() throws IOException {
        Path file = folder.resolve("ball.png");

        Path first = LAB.photograph(ball(), file);
        byte[] bytes = Files.readAllBytes(first);
        Path second = LAB.photograph(ball(), file);

        assertThat(first).isEqualTo(file);
        assertThat(second).hasFileName("ball-2.png").hasBinaryContent(bytes);
        assertThat(Lab.read(first)).isEqualTo(ball());
    }

    @Test
    void valuesAreWrittenAsNumbersOrTexts() {
        assertThat(Lab.with(ball(), "scene[0].radius", 1e-5)).isEqualTo(Lab.with(ball(), "scene[0].radius", "1e-5"));
        assertThat(Lab.with(ball(), "settings.width", 123).settings().width()).isEqualTo(123);
        assertThat(Lab.with(ball(), "scene[0].centre", "1,2,3").scene())
                .isEqualTo(Lab.with(ball(), "scene[0].centre", "[1, 2, 3]").scene());
    }

    @Test
    void mistakesHaveTheMessagesOfTheCommandLine() {
        Map<String, ThrowingCallable> mistakes = Map.of(
                "with: velocity.beta: must be at least 0 and below 1 (the speed of light), was 1.2",
                () -> Lab.with(ball(), "velocity.beta", 1.2),
                "text:1:21: scene[0]: unknown type \"Spere\"",
                () -> Lab.read("{\"scene\": [{\"type\": \"Spere\"}]}", folder),
                "there is no such file",
                () -> Lab.read(folder.resolve("none.json")),
                "must end in .png",
                () -> LAB.photograph(ball(), folder.resolve("ball.bmp")),
                "there is no folder",
                () -> LAB.photograph(ball(), folder.resolve("no/ball.png")),
                "kind must be one of between, profile, circle, line, was angle",
                () -> LAB.measure(ball(), "angle", 1, 2, 3, 4),
                "circle needs the columns and rows of 3 or more pixels, was 4 numbers",
                () -> LAB.measure(ball(), "circle", 1, 2, 3, 4),
                "pixels must lie in the picture, from -0.5,-0.5 to 79.5,59.5, was 80.0,4.0",
                () -> LAB.measure(ball(), "between", 1, 2, 80, 4));
        mistakes.forEach((said, mistake) ->
                assertThatThrownBy(mistake).isInstanceOf(MistakeException.class).hasMessageContaining(said));
    }
}
