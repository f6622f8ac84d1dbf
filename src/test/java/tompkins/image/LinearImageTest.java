package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class LinearImageTest {

    @Test
    void findsEachValueOfEachPixel() {
        LinearImage image = new LinearImage(2, 2, new float[] {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});

        assertThat(image.value(0, 0, 0)).isEqualTo(0);
        assertThat(image.value(1, 0, 2)).isEqualTo(5);
        assertThat(image.value(0, 1, 1)).isEqualTo(7);
        assertThat(image.value(1, 1, 2)).isEqualTo(11);
    }

    @Test
    void namesThePixelThatDoesNotExist() {
        LinearImage image = Samples.random(3, 2, 1);

        assertThatThrownBy(() -> image.value(3, 0, 0))
                .isInstanceOf(IndexOutOfBoundsException.class)
                .hasMessageContaining("(3, 0)")
                .hasMessageContaining("3 x 2");
        assertThatThrownBy(() -> image.value(0, 2, 0)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> image.value(0, 0, 3)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> image.value(-1, 1, 0)).isInstanceOf(IndexOutOfBoundsException.class);
    }

    @Test
    void refusesImpossibleSizes() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new LinearImage(0, 5, new float[0]))
                .withMessageContaining("1 or more")
                .withMessageContaining("0 x 5");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new LinearImage(4, 2, new float[23]))
                .withMessageContaining("24")
                .withMessageContaining("23");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> LinearImage.requireSize(26755, 26755))
                .withMessageContaining("715827882")
                .withMessageContaining("26755 x 26755");
        assertThat(LinearImage.requireSize(26754, 26754)).isEqualTo(2147329548);
    }
}
