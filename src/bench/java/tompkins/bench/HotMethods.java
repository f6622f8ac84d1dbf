package tompkins.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.results.format.ResultFormatType;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;

/** Runs {@link HotMethodsBenchmark}. */
final class HotMethods {

    private HotMethods() {}

    /** Measures all, with so many milliseconds for each repetition, and gives the table as Markdown. */
    static String measure(int milliseconds) throws RunnerException, IOException {
        Files.createDirectories(Path.of("target"));
        OptionsBuilder options = new OptionsBuilder();
        options.include(HotMethodsBenchmark.class.getName())
                .resultFormat(ResultFormatType.JSON)
                .result("target/jmh.json")
                .measurementTime(TimeValue.milliseconds(milliseconds))
                .warmupTime(TimeValue.milliseconds(milliseconds));
        StringBuilder table = new StringBuilder("\n## Hot methods\n\n| method | ns | error |\n| --- | --- | --- |\n");
        for (RunResult result : new Runner(options.build()).run()) {
            String shape = result.getParams().getParam("shape");
            Result<?> time = result.getPrimaryResult();
            table.append(String.format(
                    Locale.ROOT,
                    "| %s%s | %.1f | %.1f |%n",
                    time.getLabel(),
                    shape == null ? "" : ", " + shape,
                    time.getScore(),
                    time.getScoreError()));
        }
        return table.toString();
    }
}
