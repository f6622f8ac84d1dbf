package tompkins.app;

import java.util.List;
import picocli.CommandLine.Option;
import tompkins.io.Assignment;

/** Options that give other values to a scene whose samples are taken. */
final class SampledOptions extends SceneOptions {

    @Option(names = "--seed", paramLabel = "N", description = "seed for the positions of the samples")
    private String seed;

    @Override
    List<Assignment> assignments() {
        List<Assignment> all = super.assignments();
        add("--seed", seed, all);
        return all;
    }
}
