package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.MathContext;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Refraction between media that hardly differ, and at the critical angle. */
class RefractionLimitsTest {

    private static final MathContext DIGITS = new MathContext(60);

    /** The exact component against the normal behind the surface, for a ray whose direction is (s, 0, -c). */
    private static BigDecimal cosineBehind(double sine, double cosine, double ratio) {
        BigDecimal s = new BigDecimal(sine);
        BigDecimal c = new BigDecimal(cosine);
        BigDecimal length = s.pow(2).add(c.pow(2));
        BigDecimal eta = BigDecimal.ONE.divide(new BigDecimal(ratio), DIGITS);
        return BigDecimal.ONE
                .subtract(eta.pow(2).multiply(s.pow(2)).divide(length, DIGITS))
                .sqrt(DIGITS);
    }

    @ParameterizedTest
    @CsvSource({"1e-6, 0.01", "1e-9, 1e-3", "1e-12, 1e-4", "1e-9, 0.5"})
    void nearlyEqualMediaHardlyBendLight(double excess, double cosine) {
        double sine = Math.sqrt((1 - cosine) * (1 + cosine));
        double ratio = 1 + excess;
        double exact = cosineBehind(sine, cosine, ratio).doubleValue();
        Vector3d d = new Vector3d(sine, 0, -cosine);
        Vector3d bent = new Vector3d();
        Refraction.bend(d, new Vector3d(0, 0, 1), 1, ratio, bent);
        double error = Math.abs(-bent.z - exact);
        assertThat(error).isLessThan(4e-16 * (1 + excess / (cosine * cosine)));
    }

    @Test
    void equalMediaLeaveTheDirectionAlone() {
        Vector3d d = new Vector3d(0.6, 0, -0.8);
        Vector3d bent = new Vector3d();
        assertThat(Refraction.bend(d, new Vector3d(0, 0, 1), 1.5, 1.5, bent)).isCloseTo(0.8, within(1e-15));
        assertThat(bent.distance(d)).isLessThan(2e-16);
        assertThat(Refraction.reflectance(1.5, 1.5, 0.8, 0.8)).isZero();
    }

    /** On both sides of the critical angle the light is all there, and hardly any is transmitted next to it. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1e-8, 1e-15, 0, -1e-15, -1e-8, -1e-3})
    void reflectanceIsContinuousAtTheCriticalAngle(double beyond) {
        double angle = Math.asin(1 / 1.5) + beyond;
        Vector3d d = new Vector3d(Math.sin(angle), 0, Math.cos(angle));
        Vector3d result = new Vector3d();
        double cosineBehind = Refraction.bend(d, new Vector3d(0, 0, 1), 1.5, 1, result);
        double reflected = Refraction.reflectance(1.5, 1, Math.cos(angle), cosineBehind);
        assertThat(result.length()).isCloseTo(1, within(1e-15));
        assertThat(reflected).isBetween(0.0, 1.0);
        assertThat(1 - reflected).isLessThan(10 * Math.sqrt(Math.abs(beyond) + 1e-15));
        if (beyond >= 1e-8) {
            assertThat(cosineBehind).isZero();
            assertThat(result.z).isCloseTo(-Math.cos(angle), within(1e-15));
        }
    }

    @Test
    void grazingLightIsReflected() {
        Vector3d d = new Vector3d(Math.sqrt(1 - 1e-20), 0, -1e-10);
        Vector3d result = new Vector3d();
        double cosineBehind = Refraction.bend(d, new Vector3d(0, 0, 1), 1, 1.5, result);
        assertThat(Refraction.reflectance(1, 1.5, 1e-10, cosineBehind)).isCloseTo(1, within(1e-9));
        assertThat(result.isFinite()).isTrue();
    }
}
