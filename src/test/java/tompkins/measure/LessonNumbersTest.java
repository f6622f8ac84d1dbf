package tompkins.measure;

import static java.lang.Math.acos;
import static java.lang.Math.atan;
import static java.lang.Math.atan2;
import static java.lang.Math.sqrt;
import static java.lang.Math.tan;
import static java.lang.Math.toDegrees;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.io.BundledScenes;
import tompkins.io.StudioReader;
import tompkins.lesson.Lesson;
import tompkins.lesson.LessonNumber;
import tompkins.lesson.Prediction;
import tompkins.studio.Studio;

/** Each lesson of the program measures what closed formulas say; they stand here, and not in the scene files. */
class LessonNumbersTest {

    static Stream<Arguments> lessons() {
        return Stream.of(
                lesson("01-round-ball", radiusSeenAt(0.8), toDegrees(Math.asin(0.1))),
                lesson("02-turned-cube", 0.8 * gamma(0.8), 1 / gamma(0.8)),
                lesson("03-bent-rod", boas(0), boas(1), boas(3)),
                lesson("04-coming-and-going", doppler(0.6), 1 / doppler(0.6)),
                lesson("05-faster-than-light", 0.95 * gamma(0.95)),
                lesson("06-headlight", Math.pow(1.8 / 0.2, 4), toDegrees(acos(0.8))),
                lesson("07-colours", doppler(0.5), gamma(0.5), 1 / gamma(0.5), 1),
                lesson("08-late-shadow", 2 * 0.8 * 3, 1),
                lesson("09-clocks", doppler(0.6), 1 / doppler(0.6), 1 / gamma(0.6)),
                lesson("10-rod-in-the-barn", 10 / gamma(0.8), gamma(0.8) * 0.8 * 6),
                lesson(
                        "11-slices",
                        0.8 * gamma(0.8) * (1 - 1.0 / 5),
                        0.8 * gamma(0.8) * (1 - 1.0 / 20),
                        0.8 * gamma(0.8)),
                lesson("12-shutter", blurAtTheLens(), 0),
                lesson("13-train-and-lightning", endOfRing(1), endOfRing(-1), 1),
                lesson(
                        "14-rolling-wheel",
                        spoke(Math.PI * 9 / 8, 0.6),
                        spoke(Math.PI / 8, -0.6),
                        1 / gamma((0.8 + 0.72) / (1 + 0.8 * 0.72))),
                lesson("15-who-moves", radiusAhead(0.8), radiusAhead(0.8), 1),
                lesson(
                        "16-full-thrust",
                        toDegrees(2 * atan(0.3)),
                        2 * aberrated(toDegrees(atan(0.3)), 0.9),
                        2 * aberrated(120, 0.9)),
                lesson("18-twins", 3 / doppler(0.8), 3 * doppler(0.8), 6 * gamma(0.8)));
    }

    /**
     * A flash at the distance gamma along a wall, gamma v before or after time 0 and 0.5 from the wall, at time 2.5.
     */
    private static double endOfRing(double before) {
        double age = 2.5 + before * gamma(0.6) * 0.6;
        return toDegrees(Math.atan((gamma(0.6) + Math.sqrt(age * age - 0.25)) / 4));
    }

    private static Arguments lesson(String name, double... values) {
        return arguments(name, values);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("lessons")
    void numbersAreThoseOfTheFormulas(String name, double... formulas) throws IOException {
        LessonStudio lesson = LessonStudio.of(studio(name)).orElseThrow();
        List<LessonResult> results = lesson.results();
        assertThat(results).hasSameSizeAs(formulas);
        IntStream.range(0, formulas.length).forEach(i -> {
            LessonNumber number = results.get(i).number();
            double formula = formulas[i];
            assertThat(number.tolerance())
                    .as("a tolerance tells right from wrong: %s", number.name())
                    .isLessThan(0.006 * Math.max(Math.abs(formula), 0.001));
            assertThat(number.value()).as(number.name()).isCloseTo(formula, within(number.tolerance() / 2));
            assertThat(results.get(i).measured()).as(number.name()).isCloseTo(formula, within(number.tolerance()));
            assertThat(results.get(i).agrees()).isTrue();
        });
    }

    /** The question is asked beside the picture of the file. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("lessons")
    void picturesWithTheQuestionDoNotAnswerIt(String name, double... formulas) throws IOException {
        LessonStudio lesson = LessonStudio.of(studio(name)).orElseThrow();
        double shown = lesson.number().in(lesson.studio());
        assertThat(shown).isEqualTo(lesson.lesson().control().from());
        assertThat(shown).isNotEqualTo(lesson.lesson().control().measuredAt());
    }

    /** Nobody can tell the right answer from its length, or from a reason that only it has. */
    @Test
    void answersDoNotGiveThemselvesAway() throws IOException {
        List<Lesson> all = BundledScenes.studios().stream()
                .map(Studio::lesson)
                .filter(Lesson.class::isInstance)
                .map(Lesson.class::cast)
                .toList();
        long shortest = 0;
        long longest = 0;
        for (Lesson lesson : all) {
            List<String> answers =
                    lesson.predictions().stream().map(Prediction::text).toList();
            int right = answers.get(lesson.right() - 1).length();
            IntSummaryStatistics lengths =
                    answers.stream().mapToInt(String::length).summaryStatistics();
            shortest += right == lengths.getMin() ? 1 : 0;
            longest += right == lengths.getMax() ? 1 : 0;
            for (String reason : List.of(":", "because", ";")) {
                assertThat(answers.stream()
                                .filter(text -> text.contains(reason))
                                .count())
                        .as("“%s” in “%s”", reason, lesson.question())
                        .isIn(0L, (long) answers.size());
            }
        }
        assertThat(shortest).isLessThanOrEqualTo(all.size() / 2);
        assertThat(longest).isLessThanOrEqualTo(all.size() / 2);
    }

    /** Until the lesson is done, its title asks. */
    @Test
    void titlesAreQuestions() throws IOException {
        assertThat(BundledScenes.studios().stream().filter(studio -> studio.lesson() instanceof Lesson))
                .extracting(Studio::title)
                .allMatch(title -> title.matches("Lesson [0-9]+: .*[?]"));
    }

    @Test
    void everyLessonOfTheProgramIsHere() throws IOException {
        List<Studio> found = BundledScenes.studios().stream()
                .filter(studio -> studio.lesson() instanceof Lesson)
                .toList();
        // and the one that counts stars
        assertThat(found).hasSize((int) lessons().count() + 1);
        assertThat(found).extracting(Studio::topic).containsOnly("Lessons");
    }

    /**
     * The catalogue read line by line: a star at the angle a is ahead if cos a is above -v. An even sky of as many
     * stars has half of them ahead, and (1 + v)/2.
     */
    @Test
    void starsAheadAreThoseOfTheCatalogue() throws IOException {
        double[] cosines = cosinesToOrion();
        List<LessonResult> results =
                LessonStudio.of(studio("17-stars-ahead")).orElseThrow().results();

        assertThat(cosines).hasSize(5044);
        assertThat(results).hasSize(4).allMatch(LessonResult::agrees);
        double[] speeds = {0, 0.5, 0.9};
        for (int i = 0; i < speeds.length; i++) {
            double speed = speeds[i];
            assertThat(results.get(i).measured())
                    .isEqualTo(Arrays.stream(cosines)
                            .filter(cosine -> cosine > -speed)
                            .count());
            assertThat(results.get(i).number().value()).isEqualTo(Math.rint((1 + speed) / 2 * 5044));
        }
        assertThat(results.get(3).measured()).isEqualTo(1);
    }

    /** Cosines of the angles between Orion, at 84 degrees of right ascension, and all stars to magnitude 6. */
    private static double[] cosinesToOrion() throws IOException {
        try (InputStream stars = Studio.class.getResourceAsStream("/tompkins/light/stars.csv")) {
            return new String(stars.readAllBytes(), StandardCharsets.US_ASCII)
                    .lines()
                    .filter(line -> !line.startsWith("#") && !line.startsWith("ra"))
                    .map(line -> Arrays.stream(line.split(","))
                            .mapToDouble(Double::parseDouble)
                            .toArray())
                    .filter(star -> star[2] <= 6)
                    .mapToDouble(star -> Math.cos(Math.toRadians(star[1])) * Math.cos(Math.toRadians(star[0] - 84)))
                    .toArray();
        }
    }

    /** The front of the cube is 0.6 wide, at a distance of 1000, and its edges are marked where they are seen. */
    @Test
    void theSketchIsWhereItWasMeasured() throws IOException {
        LessonStudio lesson = LessonStudio.of(studio("02-turned-cube")).orElseThrow();
        Sketch front = lesson.results().get(1).sketch();
        assertThat(front.points()).hasSize(2);
        assertThat(front.lines()).containsExactly(front.points());
        double field = Math.toRadians(lesson.studio().camera().horizontalAngleDegrees());
        double pixels = 0.6
                / 1000
                / (2 * Math.tan(field / 2))
                * lesson.studio().settings().width();
        assertThat(front.points().get(1).x() - front.points().get(0).x()).isCloseTo(pixels, within(0.2));
        assertThat(front.points().get(0).y()).isEqualTo(front.points().get(1).y());
    }

    /** A unit of time later the ball of lesson 5 is seen 3.042 bars of its ruler, of 34 in all, farther right. */
    @Test
    void theSecondPlaceOfTheFastBallIsDrawn() throws IOException {
        LessonStudio lesson = LessonStudio.of(studio("05-faster-than-light")).orElseThrow();
        Sketch both = lesson.results().get(0).sketch();
        double field = Math.toRadians(lesson.studio().camera().horizontalAngleDegrees());
        double pixels = 3.042
                / 10000
                / (2 * tan(field / 2))
                * lesson.studio().settings().width();

        assertThat(both.points()).hasSize(2);
        assertThat(both.points().get(1).x() - both.points().get(0).x()).isCloseTo(pixels, within(0.5));
        assertThat(both.lines()).containsExactly(both.points());
    }

    /** In a panorama each degree from straight ahead is as wide as any other. */
    @Test
    void starsAreCountedWithinACircle() throws IOException {
        LessonStudio lesson = LessonStudio.of(studio("17-stars-ahead")).orElseThrow();
        Sketch circle = lesson.results().get(3).sketch();
        double pixels = lesson.studio().settings().width() / 360.0;
        double middle = lesson.studio().settings().width() / 2.0;
        List<Vector2dc> places = circle.lines().stream().flatMap(List::stream).toList();
        assertThat(places.stream().mapToDouble(Vector2dc::x).max().orElseThrow() - middle)
                .isCloseTo(toDegrees(acos(0.9)) * pixels, within(0.1));
        assertThat(places.stream().mapToDouble(Vector2dc::x).min().orElseThrow() - middle)
                .isCloseTo(-toDegrees(acos(0.9)) * pixels, within(0.1));
        // that of all that is ahead runs up and down the sides of the picture
        assertThat(lesson.results().get(2).sketch().lines())
                .isNotEmpty()
                .allSatisfy(line ->
                        assertThat(line.get(0).x()).isCloseTo(line.get(1).x(), within(1e-6)));
    }

    @Test
    void theLessonOfTheDocumentWorks() throws IOException {
        String page = Files.readString(Path.of(System.getProperty("basedir", ""), "docs", "lessons.md"));
        Matcher example = Pattern.compile("\n\n((?: {4}.*\n)*.*\"lesson\"(?:.*\n {4})*.*)")
                .matcher(page);
        assertThat(example.find()).isTrue();
        Studio studio = StudioReader.read("{" + example.group(1) + "}", "lessons.md", Path.of(""));
        LessonResult result = LessonStudio.of(studio).orElseThrow().results().get(0);
        double radius = 2 * Math.atan(Math.tan(Math.asin(0.1) / 2) / doppler(0.9));
        assertThat(result.measured()).isCloseTo(toDegrees(radius), within(1e-6));
        assertThat(result.agrees()).isTrue();
    }

    private static Studio studio(String name) throws IOException {
        return BundledScenes.studio("lesson-" + name + ".json");
    }

    /**
     * Where a spoke of a wheel of radius 1 that rolls at 0.8 c is seen from afar, at a height over the axle: with r and
     * E from {@code E - v^2 r sin E = M} and {@code y = -r cos E}, between the lowest point and 45 degrees behind it,
     * or the same above.
     */
    private static double spoke(double mean, double height) {
        double half = height < 0 ? 0 : Math.PI;
        double low = half;
        double high = half + Math.PI / 4;
        for (int step = 0; step < 60; step++) {
            double middle = (low + high) / 2;
            double radius = -height / Math.cos(middle);
            if (middle - 0.64 * radius * Math.sin(middle) < mean) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double radius = -height / Math.cos(low);
        return -radius * Math.sin(low) / gamma(0.8);
    }

    private static double gamma(double speed) {
        return 1 / sqrt(1 - speed * speed);
    }

    /** Straight ahead. */
    private static double doppler(double speed) {
        return sqrt((1 + speed) / (1 - speed));
    }

    /** Of a ball of radius 1 at a distance of 10 across the motion, in degrees. */
    private static double radiusSeenAt(double speed) {
        double sine = 0.1;
        return toDegrees(atan2(sine, gamma(speed) * sqrt(1 - sine * sine)));
    }

    /** Of a ball of radius 1 that is 12 ahead and 3 beside the way, in degrees. */
    private static double radiusAhead(double speed) {
        double sine = 1 / sqrt(153);
        return toDegrees(atan2(sine, gamma(speed) * (sqrt(1 - sine * sine) + speed * 12 / sqrt(153))));
    }

    /** An angle to the motion, in degrees, as a camera with a speed sees it. */
    private static double aberrated(double degrees, double speed) {
        return toDegrees(2 * atan(tan(Math.toRadians(degrees) / 2) / doppler(speed)));
    }

    /** Where a rod is seen at a height, at 0.9 c in the plane z = 1, when it passes x = 0. */
    private static double boas(double y) {
        return -0.9 * gamma(0.9) * sqrt(1 + y * y);
    }

    /**
     * How far what rests in the scene moves on between the longest and the shortest way from the point (0.3, -0.2, 8)
     * to the rim of the lens, as it looks: it comes nearer meanwhile, so that the times are 1 - v cos a shorter. In
     * pixels of a picture 640 wide and 9 degrees across.
     */
    private static double blurAtTheLens() {
        Vector3d point = new Vector3d(0.3, -0.2, 8);
        Vector3d rim = new Vector3d(0.3, -0.2, 0).normalize(0.05);
        Vector3d velocity = new Vector3d(0.2, -0.1, 0.97);
        double late = point.distance(rim.negate(new Vector3d())) - point.distance(rim);
        double aside = velocity.cross(point, new Vector3d()).length() / point.length();
        double nearer = 1 - velocity.dot(point) / point.length();
        double focalLength = 320 / tan(Math.toRadians(4.5));
        return focalLength * late * aside / nearer / point.length();
    }
}
