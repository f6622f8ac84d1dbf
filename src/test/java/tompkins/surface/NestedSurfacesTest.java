package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Surfaces made of others, as deep as a scene file may nest them. */
class NestedSurfacesTest {

    private static final int DEEP = 190;

    /** Where a surface of two parts may hold another one of two parts. */
    private enum Place {
        FIRST(inner -> new Tiling(inner, Clear.DEFAULT, 1, 1, true)),
        SECOND(inner -> new Tiling(Clear.DEFAULT, inner, 1, 1, true)),
        SIDE(inner -> new TwoSided(inner, Clear.DEFAULT)),
        DARK(inner -> new CutOut(CutOut.DEFAULT.picture(), inner, Clear.DEFAULT)),
        BRIGHT(inner -> new CutOut(CutOut.DEFAULT.picture(), Clear.DEFAULT, inner));

        private final UnaryOperator<Surface> around;

        Place(UnaryOperator<Surface> around) {
            this.around = around;
        }
    }

    /** Twice the work for each level would be 2^190. */
    @ParameterizedTest
    @EnumSource
    @Timeout(value = 600, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void whatTheyAreIsKnownInNoTime(Place place) {
        Surface clear = Clear.DEFAULT;
        Surface opaque = ColouredSurface.DEFAULT;
        for (int level = 0; level < DEEP; level++) {
            clear = place.around.apply(clear);
            opaque = place.around.apply(opaque);
        }

        assertThat(clear.shadow()).isEqualTo(Shadow.NEVER);
        assertThat(opaque.shadow()).isEqualTo(Shadow.BY_POINT);
        assertThat(clear.continuation()).isEqualTo(Continuation.STRAIGHT);
        assertThat(opaque.continuation()).isEqualTo(Continuation.STRAIGHT);
    }
}
