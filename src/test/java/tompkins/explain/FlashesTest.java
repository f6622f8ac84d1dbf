package tompkins.explain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import tompkins.io.StudioReader;
import tompkins.render.Quality;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.world.LitSpan;

/** What is said of flashes, held against the light of one pixel at those opening times. */
class FlashesTest {

    @AutoClose
    private static final Renderer RENDERER = new Renderer(2);

    private static final Pattern TIMES = Pattern.compile("from (-?[0-9.]+) (?:to (-?[0-9.]+)|on)");

    /** Samples in the exposure: it holds light that touches this part of it. */
    private static final int SAMPLES = 1024;

    private static final String LAMP = "'type':'PointLight','position':[0.5,0.2,-1],'flash':";
    private static final String WALL = "'type':'Plane','point':[0,0,10],'normal':[0.1,0,-1]";

    /** A picture of one pixel is lit within the ends of each span that is told, and dark without. */
    @ParameterizedTest
    @CsvFileSource(resources = "flashes.csv", delimiter = '|', quoteCharacter = '~')
    void endsOfWhatIsLitAreThoseOfThePicture(String scene) throws Exception {
        Studio studio = studio(scene);
        String sentence = new Flashes(RenderPlan.of(studio)).sentences().get(0);
        double exposure = studio.camera().exposureTime();
        double step = exposure > 0 ? exposure / SAMPLES * 3 : 1e-3;
        double now = studio.camera().shutter().openingTime();
        boolean isLitNow = light(studio, now) > 0;

        List<double[]> spans = spans(sentence);
        assertThat(spans).as(sentence).isNotEmpty();
        assertThat(sentence).contains(isLitNow ? "picture is lit" : "picture would be lit");
        for (double[] span : spans) {
            assertThat(light(studio, span[0] - 1e-3)).as("before %s", sentence).isZero();
            assertThat(light(studio, span[0] + step))
                    .as("first of %s", sentence)
                    .isPositive();
            assertThat(light(studio, span[1] - step)).as("last of %s", sentence).isPositive();
            assertThat(light(studio, span[1] + 1e-3)).as("after %s", sentence).isZero();
        }
    }

    /**
     * A lamp that comes with gamma 1000 lights the wall at (0, 0, 10) when light from (x, y, gamma beta tau) gets there
     * that left at gamma tau. The ends are by arithmetic of 50 digits.
     */
    @Test
    void endsKeepTheirDigitsForAFastLamp() throws Exception {
        RenderPlan plan = RenderPlan.of(studio("'scene':[{'type':'Plane','point':[0,0,10],'normal':[0,0,-1]}],"
                + "'lights':[{'type':'Moving','velocity':[0,0,0.9999995],'objects':[{'type':'PointLight',"
                + "'position':[0.5,0.25,0],'flash':{'start':-6,'duration':1}}]}],'camera':{SHUT OPEN20}}"));
        LitSpan span = plan.middleHistory().end().flashes().get(0).spans().get(0);
        assertThat(20 + span.from()).isCloseTo(19.997025997970905678, within(2e-14));
        assertThat(20 + span.to()).isCloseTo(19.997531187323926942, within(2e-14));
    }

    @Test
    void warnsOnlyIfTheExposureHoldsNoLight() throws Exception {
        String scene = "'scene':[{WALL}],'lights':[{LAMP{'start':0,'duration':0.1}}],'camera':{EXPOSE10 SHUT OPEN";
        assertThat(new Flashes(RenderPlan.of(studio(scene + "15}}"))).warning()).isEmpty();
        assertThat(new Flashes(RenderPlan.of(studio(scene + "9}}"))).warning())
                .hasValueSatisfying(warning -> assertThat(warning).startsWith("no flash lights anything"));
    }

    private static List<double[]> spans(String sentence) {
        List<double[]> spans = new ArrayList<>();
        Matcher times = TIMES.matcher(sentence);
        while (times.find()) {
            spans.add(new double[] {Double.parseDouble(times.group(1)), Double.parseDouble(times.group(2))});
        }
        return spans;
    }

    private static double light(Studio studio, double opening) throws InterruptedException {
        Studio opened = studio.withCamera(
                studio.camera().withShutter(studio.camera().shutter().openedAt(opening)));
        int samples = studio.camera().exposureTime() > 0 ? SAMPLES : 1;
        float[] rgb = RENDERER.render(RenderPlan.of(opened), new Quality.Samples(samples))
                .image()
                .rgb();
        return rgb[0];
    }

    private static Studio studio(String scene) throws Exception {
        String json = "{'settings':{'width':1,'height':1},'background':{'type':'UniformBackground','colour':0},"
                + scene.replace("WALL", WALL)
                        .replace("LAMP", LAMP)
                        .replaceAll("EXPOSE([0-9.]+)", "'exposureTime':$1,'horizontalAngleDegrees':0.001,")
                        .replaceAll(
                                "SHUT OPEN(-?[0-9.]+)", "'shutter':{'type':'AperturePlaneShutter','openingTime':$1}")
                        .replaceAll("OPEN(-?[0-9.]+)", "'openingTime':$1");
        return StudioReader.read(json.replace('\'', '"'), "flash.json", Path.of("."));
    }
}
