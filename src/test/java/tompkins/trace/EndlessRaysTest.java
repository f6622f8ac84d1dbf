package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import tompkins.io.StudioReader;

/** Rays among mirrors that lose no light: only the depth limit ends them. */
class EndlessRaysTest {

    private static RenderPlan plan(String surface, int depth) {
        return RenderPlan.of(StudioReader.read(
                "{\"scene\": [{\"type\": \"Sphere\", \"centre\": [0, 0, 0], \"radius\": 20, \"surface\": " + surface
                        + "}], \"settings\": {\"width\": 2, \"height\": 2, \"maximumDepth\": " + depth + "}}",
                "endless",
                Path.of(".")));
    }

    private static String mixture(int levels) {
        return levels == 0
                ? "{\"type\": \"Mirror\", \"reflectance\": 1}"
                : "{\"type\": \"Mixture\", \"first\": " + mixture(levels - 1) + ", \"second\": " + mixture(levels - 1)
                        + "}";
    }

    /** A ray of depth D has hit D + 1 times; of these the first ten thousand are kept, and the last. */
    @Test
    void ofTooManyHitsTheFirstAndTheLastAreKept() {
        int depth = 30_000;
        SampleHistory life = SampleHistory.of(plan(mixture(0), depth), 1.3, 0.2, 0, 0);
        assertThat(life.hits()).hasSize(SampleHistory.MOST_HITS + 1);
        assertThat(life.hits().size() + life.hitsLeftOut()).isEqualTo(depth + 1);
        double first = life.hits().get(0).distance();
        double chord = life.hits().get(1).distance();
        assertThat(life.end()).isSameAs(life.hits().get(SampleHistory.MOST_HITS));
        // all chords of a ray in a sphere have one length, and light takes the time of their length
        assertThat(-life.end().event().time())
                .isCloseTo(first + depth * chord - life.cameraStart().time(), within(1e-6 * depth));
        assertThat(life.reachesBackground()).isFalse();
    }

    /** Two mirrors at each point, until a branch is too faint to be split: 2^k branches at the k-th hit. */
    @Test
    void weakerBranchesAreNotKeptForEver() {
        SampleHistory life = SampleHistory.of(plan(mixture(1), 200), 1.3, 0.2, 0, 0);
        assertThat(life.mainHits()).hasSize(201);
        assertThat(life.hits()).hasSize(201 + SampleHistory.MOST_HITS);
        assertThat(life.hitsLeftOut()).isGreaterThan(50_000);
    }

    /** Whoever asks for the way alone gets the same main branch, and waits for few hits of the others. */
    @Test
    void theWayIsThatOfTheMainBranch() {
        RenderPlan plan = plan(mixture(2), 1000);
        SampleHistory all = SampleHistory.of(plan, 1.3, 0.2, 0, 0);
        SampleHistory way = SampleHistory.way(plan, 1.3, 0.2);
        assertThat(way.mainHits()).hasSize(1001).hasSameSizeAs(all.mainHits());
        assertThat(way.end().event()).isEqualTo(all.end().event());
        assertThat(way.hits().size() + way.hitsLeftOut()).isLessThan(1001 + 200);
        assertThat(all.hits().size() + all.hitsLeftOut()).isGreaterThan(500_000);
    }
}
