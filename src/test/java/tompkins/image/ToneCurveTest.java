package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class ToneCurveTest {

    /** The examples of the scene's specification: tiles of 0.1 and 0.2, sky, sky through a window of 0.96. */
    @ParameterizedTest
    @CsvSource({"0.1, 25", "0.2, 51", "0.5, 127", "1, 255", "0.48, 122", "0.96, 244", "0, 0", "0.99999, 254"})
    void linearCutsOff(double light, int level) {
        assertThat(ToneCurve.LINEAR.quantise(light, 255)).isEqualTo(level);
    }

    /** Level n of sRGB stands for the light that IEC 61966-2-1 gives for n / 255, by its inverse formula. */
    @Test
    void srgbIsTheInverseOfTheStandardsDecoding() {
        for (int maximum : new int[] {255, 65535}) {
            for (int level = 0; level <= maximum; level++) {
                double encoded = (double) level / maximum;
                double light = encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
                assertThat(ToneCurve.SRGB.quantise(light, maximum)).isEqualTo(level);
            }
        }
        assertThat(ToneCurve.SRGB.quantise(0.5, 255)).isEqualTo(188);
        assertThat(ToneCurve.SRGB.quantise(0.001, 255)).as("3.29 rounded").isEqualTo(3);
        assertThat(ToneCurve.SRGB.quantise(0.00091, 255)).as("2.998 rounded").isEqualTo(3);
    }

    @ParameterizedTest
    @EnumSource
    void lightBeyondTheScreenIsClipped(ToneCurve curve) {
        assertThat(curve.quantise(-0.5, 255)).isZero();
        assertThat(curve.quantise(Double.NEGATIVE_INFINITY, 255)).isZero();
        assertThat(curve.quantise(Double.NaN, 255)).isZero();
        assertThat(curve.quantise(1.5, 255)).isEqualTo(255);
        assertThat(curve.quantise(Double.POSITIVE_INFINITY, 65535)).isEqualTo(65535);
    }

    @ParameterizedTest
    @EnumSource
    void theTableGivesTheLevelsOfTheCurve(ToneCurve curve) {
        LevelTable table = LevelTable.of(curve);
        Random random = new Random(11);
        for (int i = 0; i < 200_000; i++) {
            float light = (float) Math.pow(random.nextDouble() * 1.1, 4);
            assertThat(table.level(light)).as("level of %s", light).isEqualTo(curve.quantise(light, 255));
        }
        for (float light : new float[] {-1, -0f, 0, Float.NaN, 1, Math.nextDown(1f), 2, Float.POSITIVE_INFINITY}) {
            assertThat(table.level(light)).as("level of %s", light).isEqualTo(curve.quantise(light, 255));
        }
    }

    @ParameterizedTest
    @EnumSource
    void theTableChangesLevelAtTheSameFloatAsTheCurve(ToneCurve curve) {
        LevelTable table = LevelTable.of(curve);
        for (int level = 1; level < 255; level++) {
            double encoded = (level - (curve == ToneCurve.SRGB ? 0.5 : 0)) / 255;
            double edge = curve == ToneCurve.LINEAR
                    ? encoded
                    : encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
            float light = (float) edge;
            for (int step = 0; step < 20; step++) {
                light = Math.nextDown(light);
            }
            for (int step = 0; step < 40; step++, light = Math.nextUp(light)) {
                assertThat(table.level(light)).isEqualTo(curve.quantise(light, 255));
            }
        }
    }
}
