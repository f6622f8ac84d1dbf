package tompkins.animation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FilmAssemblyTest {

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0 1 2 3 4 | 0-4",
                "1 3 5 | 1-5x2",
                "0 9 | 0,9",
                "1 3 4 5 | 1,3-5",
                "4 | 4",
                "0 10 20 27 | 0-20x10,27"
            })
    void framesAreNamedShortly(String frames, String list) {
        assertThat(FilmAssembly.text(List.of(frames.split(" ")).stream()
                        .map(Integer::valueOf)
                        .toList()))
                .isEqualTo(list);
    }
}
