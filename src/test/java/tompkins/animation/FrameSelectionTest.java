package tompkins.animation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.property.InvalidPropertyException;

class FrameSelectionTest {

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "7 | 7",
                "0-3 | 0 1 2 3",
                "0-99x40 | 0 40 80",
                "3,5-8 | 3 5 6 7 8",
                "' 3, 5 - 6 ' | 3 5 6",
                "8,2,2-3 | 2 3 8",
                "99-99x5 | 99"
            })
    void listsNameFrames(String list, String frames) {
        List<Integer> expected =
                List.of(frames.split(" ")).stream().map(Integer::valueOf).toList();
        assertThat(FrameSelection.parse(list, 100).frames()).isEqualTo(expected);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "100", "-1", "5-3", "0-100", "0-9x0", "1;2", "1,,2", "x2", "0-9x", "1.5", "9999999999"})
    void otherListsAreRefused(String list) {
        assertThatThrownBy(() -> FrameSelection.parse(list, 100))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessage("frames must be numbers from 0 to 99 or ranges of them, such as 99, 0-99, 0-99x2 or 0,1-99,"
                        + " was " + (list.isEmpty() ? "\"\"" : list));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"0 1 2 3 4 | 0-4", "1 3 5 | 1-5x2", "0 9 | 0,9", "1 3 4 5 | 1,3-5", "4 | 4"})
    void framesAreNamedShortly(String frames, String list) {
        List<Integer> numbers =
                List.of(frames.split(" ")).stream().map(Integer::valueOf).toList();
        assertThat(new FrameSelection(numbers)).hasToString(list);
    }

    @Test
    void whatIsNamedIsFoundAgain() {
        Random random = new Random(1);
        for (int i = 0; i < 200; i++) {
            double share = random.nextDouble();
            List<Integer> frames =
                    new ArrayList<>(IntStream.range(0, 60).boxed().toList());
            frames.removeIf(frame -> frame > 0 && random.nextDouble() > share);
            FrameSelection selection = new FrameSelection(frames);
            assertThat(FrameSelection.parse(selection.toString(), 60)).isEqualTo(selection);
        }
    }
}
