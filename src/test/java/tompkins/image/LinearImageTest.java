package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

class LinearImageTest {

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
