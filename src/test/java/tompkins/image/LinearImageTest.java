package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class LinearImageTest {

    @Test
    void namesThePixelThatDoesNotExist() {
        LinearImage image = new LinearImage(3, 2, new float[18]);
        for (int[] at : new int[][] {{3, 0, 0}, {0, 2, 0}, {0, 0, 3}, {-1, 1, 0}}) {
            assertThatThrownBy(() -> image.value(at[0], at[1], at[2]))
                    .isInstanceOf(IndexOutOfBoundsException.class)
                    .hasMessage("no channel %d of pixel (%d, %d) in a picture of 3 x 2 pixels", at[2], at[0], at[1]);
        }
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
