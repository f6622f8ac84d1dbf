package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.animation.RideFilm;
import tompkins.image.FramePicture;
import tompkins.image.PictureDifference;
import tompkins.image.ToneCurve;
import tompkins.io.StudioReader;
import tompkins.studio.RideMoment;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.trace.RenderPlan;
import tompkins.ui.model.Pace;

/** Pictures that are seen for a moment. The size is that of the picture in a window of 1366 x 768 pixels. */
class PreviewFilmTest {

    private static final int WIDTH = 826;
    private static final int HEIGHT = 620;
    private static final Renderer RENDERER = new Renderer();

    @AfterAll
    static void close() {
        RENDERER.close();
    }

    private static RenderPlan plan(Studio studio) {
        return RenderPlan.of(studio.withSettings(studio.settings().withSize(WIDTH, HEIGHT)));
    }

    private static RenderJob glimpse(RenderPlan plan, double samples) throws InterruptedException {
        PreviewFilm film = new PreviewFilm(
                WIDTH, HEIGHT, plan.exposure(), plan.studio().settings().toneCurve());
        RenderJob job = RENDERER.start(
                plan,
                new EdgeSchedule(film, speed -> (long) (samples * WIDTH * HEIGHT)),
                film,
                Tile.of(WIDTH, HEIGHT),
                RenderListener.NONE,
                ended -> {});
        job.await();
        return job;
    }

    /** The pictures of the ride with one sample in each pixel, which all tests compare theirs with. */
    private static final Map<Studio, BufferedImage> WHOLE = new HashMap<>();

    private static double samples(RenderJob job) {
        return job.samples() / (double) (WIDTH * HEIGHT);
    }

    private static BufferedImage wholeLevels(RenderPlan plan) throws InterruptedException {
        BufferedImage known = WHOLE.get(plan.studio());
        if (known == null) {
            known = RENDERER.render(plan, new Quality.Samples(1)).levels().image();
            WHOLE.put(plan.studio(), known);
        }
        return known;
    }

    /** Differences to the whole pictures on the ride of the first scene, every six seconds, moving and at rest. */
    private static List<Double> differences(double samples) throws Exception {
        RideFilm film = new RideFilm(StudioReader.read(Path.of("scenes/town-square.json")));
        List<Double> differences = new ArrayList<>();
        for (double time = 0; time <= film.seconds(); time += 6) {
            RideMoment moment = film.moment(time);
            for (Studio studio : List.of(moment.studio(), moment.atRest())) {
                RenderPlan plan = plan(studio);
                RenderJob job = glimpse(plan, samples);
                assertThat(samples(job)).isLessThan(samples + 0.01);
                differences.add(PictureDifference.ofLevels(job.levels().image(), wholeLevels(plan)));
            }
        }
        Collections.sort(differences);
        return differences;
    }

    @Test
    void aFifthOfThePixelsIsSharpOnARide() throws Exception {
        List<Double> differences = differences(0.2);
        assertThat(differences.get(differences.size() / 2)).isLessThan(4);
        assertThat(differences.get(differences.size() - 1)).isLessThan(8);
    }

    @Test
    void moreSamplesAreBetter() throws Exception {
        List<Double> few = differences(0.1);
        List<Double> more = differences(0.15);
        assertThat(more.get(more.size() / 2)).isLessThan(0.75 * few.get(few.size() / 2));
    }

    /** Thin hands and dials lie between the knots of the net: an edge is followed into the cells beside it. */
    @Test
    void thinLinesOfClocksAreFollowed() throws Exception {
        RenderPlan plan = plan(StudioReader.read(Path.of("scenes/motion-clocks.json")));
        RenderJob job = glimpse(plan, 0.165);
        assertThat(PictureDifference.ofLevels(job.levels().image(), wholeLevels(plan)))
                .isLessThan(9);
    }

    /** In Fig. 1(b) two thirds of all cells differ, many of them alike. */
    @Test
    void whatMayBeTakenIsTaken() throws Exception {
        RenderPlan plan = plan(StudioReader.read(Path.of("scenes/fig1b.json")));
        assertThat(samples(glimpse(plan, 0.165))).isBetween(0.16, 0.167);
        assertThat(samples(glimpse(plan, 0.1))).isBetween(0.097, 0.102);
    }

    /** Nothing is between the knots of the net of four by four pixels. */
    @Test
    void whereNothingDiffersTheNetIsEnough() throws Exception {
        Studio empty = Studios.sphere().withScene(List.of());
        RenderJob job = glimpse(plan(empty), 1);
        assertThat(job.samples()).isEqualTo((WIDTH + 3) / 4 * ((HEIGHT + 3) / 4));
        assertThat(job.isComplete()).isTrue();
    }

    /** All pixels beside an edge of the whole picture are those of the whole picture. */
    @Test
    void edgesAreNotSmoothed() throws Exception {
        RenderPlan plan = plan(Studios.sphere());
        BufferedImage whole = wholeLevels(plan);
        BufferedImage seen = glimpse(plan, 1).levels().image();
        int edges = 0;
        for (int row = 0; row < HEIGHT; row++) {
            for (int column = 0; column < WIDTH - 1; column++) {
                int here = whole.getRGB(column, row);
                int beside = whole.getRGB(column + 1, row);
                if (Math.abs((here & 0xff) - (beside & 0xff)) > 100) {
                    edges++;
                    assertThat(seen.getRGB(column, row)).isEqualTo(here);
                    assertThat(seen.getRGB(column + 1, row)).isEqualTo(beside);
                }
            }
        }
        assertThat(edges).isGreaterThan(100);
    }

    /** Other films interpolate light; in a soft picture that is the same. */
    @Test
    void betweenSamplesAreTheMeansOfTheirNeighbours() {
        PreviewFilm glimpse = new PreviewFilm(21, 12, 0.5, ToneCurve.LINEAR);
        Film film = new Film(21, 12, 0.5, false);
        for (int row = 0; row < 12; row++) {
            for (int column = 0; column < 21; column++) {
                boolean isFine = column > 6 && column < 13 && (column + row) % 3 == 0;
                if (row % 8 == 0 && column % 8 == 0 || isFine) {
                    double light = (column + 2 * row) / 32.0;
                    Films.add(glimpse, glimpse.pixel(column, row), light, 1, 2 - light, 1);
                    Films.add(film, film.pixel(column, row), light, 1, 2 - light, 1);
                }
            }
        }
        BufferedImage seen = glimpse.levels().image();
        BufferedImage exact = FramePicture.of(film.image(), ToneCurve.LINEAR).image();
        for (int row = 0; row < 12; row++) {
            for (int column = 0; column < 21; column++) {
                for (int channel = 0; channel < 3; channel++) {
                    assertThat(seen.getRGB(column, row) >> 8 * channel & 0xff)
                            .as("column %d, row %d", column, row)
                            .isCloseTo(exact.getRGB(column, row) >> 8 * channel & 0xff, within(1));
                }
            }
        }
        assertThat(glimpse.sampledPixels()).isEqualTo(film.sampledPixels());
    }

    /** Pictures of 10 ms and 2 microseconds for each sample fit into 60 ms with 25 000 samples. */
    @Test
    void samplesFillTheTimeThatIsThere() {
        PreviewBudget budget = new PreviewBudget();
        assertThat(settled(budget, 60, 0.01, 2e-6)).isCloseTo(25_000, within(250L));
        // twice as fast from now on; there are never more than 0.4 samples of a pixel
        assertThat(settled(budget, 60, 0.01, 1e-6)).isCloseTo(40_000, within(1L));
        // too slow for pictures that are good enough: these come less often
        assertThat(settled(budget, 60, 0.01, 8e-6)).isEqualTo(16_500);
    }

    /**
     * A picture has 12 ms that are not its rays'. Where a fifth of its pixels takes it to 30 ms, the time of a ride, it
     * has at least that fifth; where it would take longer, it has what it can be looked at with, or what rays allow.
     */
    @ParameterizedTest
    @CsvSource({"0.030, 0.2, 0.2", "0.028, 0.2, 0.25", "0.034, 0.165, 0.165", "0.060, 0.125, 0.125"})
    void aFifthIsTakenWhereThirtyPicturesFit(double secondsOfAFifth, double least, double most) {
        int pixels = WIDTH * HEIGHT;
        double each = (secondsOfAFifth - 0.012) / (0.2 * pixels);
        PreviewBudget budget = new PreviewBudget();
        long samples = 0;
        for (int i = 0; i < 60; i++) {
            samples = budget.most(1 / each, Pace.RIDE.glimpseSeconds(), pixels);
            budget.ended(0.012 + each * samples, Pace.RIDE.glimpseSeconds());
        }
        assertThat((double) samples / pixels).isBetween(least - 1e-4, most + 1e-4);
    }

    /** With 0.165 samples of a pixel none of them is as near to the whole picture. */
    @ParameterizedTest
    @CsvSource({"cube, 5", "dice, 5.5", "mirror, 4.5"})
    void aFifthShowsRidesOfMotion(String scene, double levels) throws Exception {
        RenderPlan plan = plan(StudioReader.read(Path.of("scenes/motion-" + scene + ".json")));
        RenderJob job = glimpse(plan, 0.2);
        assertThat(samples(job)).isLessThan(0.21);
        assertThat(PictureDifference.ofLevels(job.levels().image(), wholeLevels(plan)))
                .isLessThan(levels);
    }

    /** A single picture that waited for something else changes the next one by a sixth. */
    @Test
    void oneSlowPictureChangesLittle() {
        PreviewBudget budget = new PreviewBudget();
        settled(budget, 60, 0.01, 2e-6);
        budget.ended(3, 0.06);
        assertThat(budget.most(1e6, 0.06, 100_000)).isCloseTo(25_000 * 5 / 6, within(250L));
    }

    /** A slow moment is not taken for a slow machine; a slow scene is, after some time. */
    @Test
    void slownessCountsOnceItLasts() {
        PreviewBudget budget = new PreviewBudget();
        budget.most(1e6, 0.02, 1_000_000);
        assertThat(budget.most(1e5, 0.02, 1_000_000)).isCloseTo(19_600, within(1L));
        for (int i = 0; i < 200; i++) {
            budget.most(1e5, 0.02, 1_000_000);
        }
        assertThat(budget.most(1e5, 0.02, 1_000_000)).isCloseTo(2000, within(1L));
    }

    private static long settled(PreviewBudget budget, int pictures, double fixed, double each) {
        long samples = 0;
        for (int i = 0; i < pictures; i++) {
            samples = budget.most(1e6, 0.06, 100_000);
            budget.ended(fixed + each * samples, 0.06);
        }
        return samples;
    }
}
