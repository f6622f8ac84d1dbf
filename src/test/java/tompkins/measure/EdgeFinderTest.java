package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class EdgeFinderTest {

    @Test
    void edgesLieWhereHalfOfTheStepIsPassed() {
        assertThat(EdgeFinder.edge(0, 0, 0, 1, 1)).isEqualTo(2.5);
        assertThat(EdgeFinder.edge(7, 7, 3)).isEqualTo(1.5);
        // a pixel that the edge cuts after a quarter of its width holds a quarter of the left and the rest of the right
        assertThat(EdgeFinder.edge(0, 0, 0, 0.75, 1, 1, 1)).isCloseTo(2.5, within(0.5));
        assertThat(EdgeFinder.edge(10, 10, 10, 8, 4, 2, 2, 2)).isCloseTo(3.5, within(0.1));
    }

    @Test
    void smallerStepsBesideItDoNotMoveAnEdge() {
        assertThat(EdgeFinder.edge(0, 0.1, 0, 0.1, 0, 5, 5.1, 5, 5.1, 5)).isCloseTo(4.5, within(0.02));
    }

    /** A slow fall over many samples is more than the step behind it, and is no edge. */
    @Test
    void shadingIsNoEdge() {
        double[] shaded = new double[200];
        for (int i = 0; i < 200; i++) {
            shaded[i] = i < 150 ? 10 - i / 20.0 : 4;
        }

        assertThat(EdgeFinder.edge(shaded)).isCloseTo(149.5, within(0.1));
    }

    @Test
    void evenProfilesHaveNoEdge() {
        assertThat(EdgeFinder.edge(0.1, 0.1, 0.1, 0.1)).isNaN();
        assertThat(EdgeFinder.edge(1, Double.NaN, 2)).isNaN();
        assertThat(EdgeFinder.edge(4)).isNaN();
        assertThat(EdgeFinder.edge()).isNaN();
    }
}
